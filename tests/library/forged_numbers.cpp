#include "forged_numbers.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>

namespace tessera::test {
namespace {

bool has_digest(const Column& column) {
  return column.path.starts_with("/outline") || column.path.starts_with("/field") ||
         column.path.starts_with("/levels") || column.path == "/shapes/part_digest";
}

/// Changes one element of the column.
template <class Change>
Forgery put(const std::string& path, ForgingChance& chance, const Column& column, Change change_element) {
  bool older = false;
  change_library(path, [&](hid_t file) {
    older = chance.make_older(file);
    if (H5Lexists(file, column.path.c_str(), H5P_DEFAULT) <= 0) return;
    const OpenColumn open = open_column(file, column);
    const std::size_t row = chance.below(open.rows());
    const std::size_t chunk_row = row - row % open.chunk_rows();
    const ChunkPacking packing = packing_of(open, column);
    std::vector<std::uint8_t> content = read_chunk_at(open, chunk_row, packing);
    const std::size_t per_row = layout::elements_per_row(column);
    const std::size_t element = (row - chunk_row) * per_row + chance.below(per_row);
    change_element(content.data() + element * layout::element_bytes(column));
    store_chunk_at(open, chunk_row, packed(content, packing));
    H5Dclose(open.set);
  });
  return {std::string("a changed element of ") + column.path + (older ? ", without digests" : ""),
          older || !has_digest(column)};
}

}  // namespace

Forgery absurd_number(const std::string& path, ForgingChance& chance) {
  const Column& column = chance.any_column();
  return put(path, chance, column, [&](std::uint8_t* at) {
    constexpr float kFloats[] = {std::numeric_limits<float>::quiet_NaN(),
                                 std::numeric_limits<float>::infinity(),
                                 -1e30f,
                                 1e30f,
                                 -1,
                                 0,
                                 1e-40f,
                                 20'000,
                                 3};
    const std::int64_t kWholes[] = {-1, 0, 1, INT16_MIN, INT32_MAX, std::int64_t(1) << 40, INT64_MAX, INT64_MIN};
    if (column.element == layout::Element::float32) {
      std::memcpy(at, &kFloats[chance.below(std::size(kFloats))], sizeof(float));
    } else {
      const std::int64_t value = kWholes[chance.below(std::size(kWholes))];
      std::memcpy(at, &value, std::min<std::size_t>(sizeof value, layout::element_bytes(column)));
    }
  });
}

Forgery flipped_content(const std::string& path, ForgingChance& chance) {
  const Column& column = chance.any_column();
  return put(path, chance, column, [&](std::uint8_t* at) {
    at[chance.below(layout::element_bytes(column))] ^= std::uint8_t(1u << chance.below(8));
  });
}

Forgery astray_offset(const std::string& path, ForgingChance& chance) {
  std::vector<Column> offsets;
  for (const Column& c : chance.columns()) {
    if (c.element == layout::Element::int64) offsets.push_back(c);
  }
  return put(path, chance, offsets[chance.below(offsets.size())], [&](std::uint8_t* at) {
    const std::int64_t value = std::int64_t(chance.below(200'000)) - 1000;
    std::memcpy(at, &value, sizeof value);
  });
}

Forgery forged_thumbnail(const std::string& path, ForgingChance& chance) {
  constexpr std::size_t kHeader_bytes = 33;  // the signature and the header of the first thumbnail
  const Column column = layout::library_columns(5).thumbnail_bytes;
  std::size_t at = 0;
  change_library(path, [&](hid_t file) {
    const OpenColumn open = open_column(file, column);
    const ChunkPacking packing = packing_of(open, column);
    std::vector<std::uint8_t> content = read_chunk_at(open, 0, packing);
    at = chance.below(kHeader_bytes);
    content[at] = std::uint8_t(content[at] ^ (1 + chance.below(255)));
    store_chunk_at(open, 0, packed(content, packing));
    H5Dclose(open.set);
  });
  return {"byte " + std::to_string(at) + " of a thumbnail", true};
}

}  // namespace tessera::test
