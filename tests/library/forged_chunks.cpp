#include "forged_chunks.h"

namespace tessera::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Stored {
  Bytes bytes;
  std::uint32_t skipped_filters = 0;
};

Stored checked(const Bytes& content, const ChunkPacking& packing) {
  return {with_checksum(packing.deflated ? deflated(content) : content)};
}

/// Replaces a valid chunk by the result of `make` for it.
template <class Make>
Forgery on_chunk(const std::string& path, ForgingChance& chance, const std::string& what, Make make) {
  const Column& column = chance.any_column();
  change_library(path, [&](hid_t file) {
    chance.make_older(file);
    if (H5Lexists(file, column.path.c_str(), H5P_DEFAULT) <= 0) return;
    const OpenColumn open = open_column(file, column);
    const std::size_t chunks = (open.rows() + open.chunk_rows() - 1) / open.chunk_rows();
    const std::size_t row = chance.below(chunks) * open.chunk_rows();
    const ChunkPacking packing = packing_of(open, column);
    const Stored stored = make(read_chunk_at(open, row, packing), packing);
    store_chunk_at(open, row, stored.bytes, stored.skipped_filters);
    H5Dclose(open.set);
  });
  return {what + " in " + column.path};
}

}  // namespace

Forgery chunk_that_inflates_to_less(const std::string& path, ForgingChance& chance) {
  return on_chunk(path, chance, "a chunk that inflates to less", [&](Bytes content, const ChunkPacking& packing) {
    content.resize(chance.below(content.size()));
    return checked(content, packing);
  });
}

Forgery chunk_that_inflates_to_more(const std::string& path, ForgingChance& chance) {
  return on_chunk(path, chance, "a chunk that inflates to more", [&](Bytes content, const ChunkPacking& packing) {
    const std::size_t extra[] = {1, 100, content.size(), 64u << 20};
    content.resize(content.size() + extra[chance.below(4)]);
    return checked(content, packing);
  });
}

Forgery chunk_with_skipped_filters(const std::string& path, ForgingChance& chance) {
  return on_chunk(path, chance, "a chunk whose filters are skipped",
                  [&](const Bytes& good, const ChunkPacking& packing) {
                    Bytes bytes = chance.below(2) == 0 ? good : packed(good, packing);
                    if (chance.below(2) == 0) bytes.resize(bytes.size() / 2);
                    return Stored{bytes, std::uint32_t(1 + chance.below(7))};
                  });
}

Forgery chunk_of_random_bytes(const std::string& path, ForgingChance& chance) {
  return on_chunk(path, chance, "a chunk of random bytes", [&](const Bytes& good, const ChunkPacking&) {
    Bytes bytes(chance.below(good.size() + 100));
    for (std::uint8_t& b : bytes) b = std::uint8_t(chance.bits());
    return Stored{with_checksum(bytes)};
  });
}

}  // namespace tessera::test
