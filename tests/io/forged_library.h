// Libraries as an attacker makes them: a good one, changed at one place by the HDF5 API, with valid checksums. Seeded.
#pragma once

#include <hdf5.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "io/library/library_chunk.h"
#include "io/library/library_layout.h"

namespace tessera::test {

/// What was done, and whether a reader may take the file for another good library: names, colours and numbers of another
/// library are no mistake.
struct Forgery {
  std::string what;
  bool may_differ = false;
};

class LibraryForger {
 public:
  using Column = io::layout::Column;

  explicit LibraryForger(std::uint32_t seed) : random_(seed), columns_(all_columns()) {}

  static constexpr int kKinds = 16;

  /// Changes the library at `path` in the way that `kind` (0 .. kKinds - 1) says, at a random place.
  Forgery forge(const std::string& path, int kind) {
    switch (kind) {
      case 0: return on_chunk(path, "a chunk that inflates to less", &LibraryForger::short_chunk);
      case 1: return on_chunk(path, "a chunk that inflates to more", &LibraryForger::long_chunk);
      case 2: return on_chunk(path, "a chunk whose filters are skipped", &LibraryForger::skipped_filters);
      case 3: return on_chunk(path, "a chunk of random bytes", &LibraryForger::random_chunk);
      case 4: return other_filters(path);
      case 5: return giant(path);
      case 6: return other_type(path);
      case 7: return other_layout(path);
      case 8: return other_link(path);
      case 9: return absurd_number(path);
      case 10: return flipped_content(path);
      case 11: return astray_offset(path);
      case 12: return forged_thumbnail(path);
      case 13: return forged_attribute(path);
      case 14: return cut(path);
      default: return flipped_bytes(path);
    }
  }

 private:
  template <class Change>
  static void change(const std::string& path, Change change) {
    const io::Hdf5Silence silence;  // what cannot be made is missing then
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, access);
    if (file < 0) throw std::runtime_error("cannot open " + path);
    change(file);
    H5Fclose(file);
    H5Pclose(access);
  }

  static std::vector<Column> all_columns() {
    const io::layout::Columns c = io::layout::library_columns(5);
    std::vector<Column> all{c.name,          c.perimeter,      c.radius,        c.mean_lab,
                            c.first_curve,   c.first_point,    c.outline_points, c.field_distance,
                            c.field_scale,   c.field_extent,   c.artwork_path,  c.artwork_size,
                            c.artwork_centroid, c.artwork_unit, c.first_thumbnail_byte, c.thumbnail_bytes,
                            c.first_original_byte, c.original_bytes, c.part_digest, c.artwork_beside,
                            c.artwork_sha256};
    for (const io::layout::LevelColumns& level : c.levels)
      all.insert(all.end(), {level.points, level.perimeter, level.lengths, level.keypoints, level.convexity});
    return all;
  }

  std::size_t below(std::size_t end) { return std::size_t(random_() % end); }
  const Column& any_column() { return columns_[below(columns_.size())]; }

  /// Without the digests of its parts, as an older version wrote it: nothing but the limits tells then.
  bool make_older(hid_t file) {
    if (below(2) == 0) return false;
    H5Ldelete(file, "/shapes/part_digest", H5P_DEFAULT);
    return true;
  }

  struct Open {
    hid_t set;
    std::vector<hsize_t> dims, chunk;
    hsize_t rows() const { return dims[0]; }
    std::size_t chunk_rows() const { return chunk[0]; }
  };

  static Open open(hid_t file, const Column& column) {
    Open o{H5Dopen2(file, column.path.c_str(), H5P_DEFAULT), {}, {}};
    const hid_t space = H5Dget_space(o.set);
    const hid_t properties = H5Dget_create_plist(o.set);
    o.dims.resize(std::size_t(H5Sget_simple_extent_ndims(space)));
    o.chunk.resize(o.dims.size());
    H5Sget_simple_extent_dims(space, o.dims.data(), nullptr);
    H5Pget_chunk(properties, int(o.chunk.size()), o.chunk.data());
    H5Pclose(properties);
    H5Sclose(space);
    return o;
  }

  static io::ChunkPacking packing_of(const Open& o, const Column& column) {
    return {o.chunk_rows() * io::layout::row_bytes(column), io::layout::element_bytes(column), column.compressed};
  }

  static std::vector<std::uint8_t> deflated(const std::vector<std::uint8_t>& bytes) {
    uLongf size = compressBound(uLong(bytes.size()));
    std::vector<std::uint8_t> packed(size);
    compress2(packed.data(), &size, bytes.data(), uLong(bytes.size()), 9);
    packed.resize(size);
    return packed;
  }

  static std::vector<std::uint8_t> shuffled(const std::vector<std::uint8_t>& bytes, std::size_t element) {
    std::vector<std::uint8_t> result(bytes.size());
    const std::size_t elements = bytes.size() / element;
    for (std::size_t i = 0; i < elements; ++i) {
      for (std::size_t b = 0; b < element; ++b) result[b * elements + i] = bytes[i * element + b];
    }
    return result;
  }

  static std::vector<std::uint8_t> with_checksum(std::vector<std::uint8_t> bytes) {
    const std::uint32_t sum = io::fletcher32(bytes);
    for (int b = 0; b < 4; ++b) bytes.push_back(std::uint8_t(sum >> 8 * b));
    return bytes;
  }

  static std::vector<std::uint8_t> packed(const std::vector<std::uint8_t>& content, const io::ChunkPacking& packing) {
    return with_checksum(packing.deflated ? deflated(shuffled(content, packing.element_bytes)) : content);
  }

  std::vector<std::uint8_t> random_bytes(std::size_t count) {
    std::vector<std::uint8_t> bytes(count);
    for (auto& b : bytes) b = std::uint8_t(random_());
    return bytes;
  }

  // Each returns what is to be stored and the filters that are declared skipped.
  using Stored = std::pair<std::vector<std::uint8_t>, std::uint32_t>;

  Stored short_chunk(const std::vector<std::uint8_t>& good, const io::ChunkPacking& packing) {
    std::vector<std::uint8_t> less(good.begin(), good.begin() + std::ptrdiff_t(below(good.size())));
    if (!packing.deflated) return {with_checksum(less), 0};
    return {with_checksum(deflated(less)), 0};
  }

  Stored long_chunk(const std::vector<std::uint8_t>& good, const io::ChunkPacking& packing) {
    std::vector<std::uint8_t> more = good;
    const std::size_t extra[] = {1, 100, good.size(), 64u << 20};
    more.resize(good.size() + extra[below(4)]);
    if (!packing.deflated) return {with_checksum(more), 0};
    return {with_checksum(deflated(more)), 0};
  }

  Stored skipped_filters(const std::vector<std::uint8_t>& good, const io::ChunkPacking& packing) {
    std::vector<std::uint8_t> bytes = below(2) == 0 ? good : packed(good, packing);
    if (below(2) == 0) bytes.resize(bytes.size() / 2);
    return {bytes, std::uint32_t(1 + below(7))};
  }

  Stored random_chunk(const std::vector<std::uint8_t>& good, const io::ChunkPacking&) {
    return {with_checksum(random_bytes(below(good.size() + 100))), 0};
  }

  Forgery on_chunk(const std::string& path, const std::string& what,
                   Stored (LibraryForger::*make)(const std::vector<std::uint8_t>&, const io::ChunkPacking&)) {
    const Column& column = any_column();
    change(path, [&](hid_t file) {
      make_older(file);
      if (H5Lexists(file, column.path.c_str(), H5P_DEFAULT) <= 0) return;
      const Open o = open(file, column);
      std::vector<hsize_t> corner(o.dims.size(), 0);
      corner[0] = below((o.rows() + o.chunk_rows() - 1) / o.chunk_rows()) * o.chunk_rows();
      const io::ChunkPacking packing = packing_of(o, column);
      const auto [bytes, skipped] = (this->*make)(io::read_chunk(o.set, corner, packing, "good"), packing);
      H5Dwrite_chunk(o.set, H5P_DEFAULT, skipped, corner.data(), bytes.size(), bytes.data());
      H5Dclose(o.set);
    });
    return {what + " in " + column.path};
  }

  /// The same numbers, packed in another way.
  Forgery other_filters(const std::string& path) {
    const Column& column = any_column();
    const std::size_t way = below(6);
    change(path, [&](hid_t file) {
      const Open o = open(file, column);
      const hid_t type = H5Dget_type(o.set);
      const hid_t space = H5Dget_space(o.set);
      const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
      H5Pset_chunk(properties, int(o.chunk.size()), o.chunk.data());
      if (way == 1) H5Pset_shuffle(properties);
      if (way == 0 || way == 2) H5Pset_deflate(properties, 9);
      if (way == 0) H5Pset_deflate(properties, 9);
      if (way == 3) H5Pset_fletcher32(properties), H5Pset_deflate(properties, 4);
      if (way == 4) H5Pset_nbit(properties);
      if (way != 5 && way != 3) H5Pset_fletcher32(properties);  // 5: no filter at all
      std::vector<char> data(std::size_t(H5Dget_storage_size(o.set)) + o.rows() * io::layout::row_bytes(column));
      H5Dread(o.set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data());
      H5Dclose(o.set);
      H5Ldelete(file, column.path.c_str(), H5P_DEFAULT);
      const hid_t made = H5Dcreate2(file, column.path.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
      H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data());
      H5Dclose(made);
      H5Pclose(properties);
      H5Sclose(space);
      H5Tclose(type);
    });
    return {"filters of way " + std::to_string(way) + " on " + column.path};
  }

  Forgery giant(const std::string& path) {
    const Column& column = any_column();
    const int bits = 8 + int(below(54));
    change(path, [&](hid_t file) {
      Open o = open(file, column);
      o.dims[0] = o.rows() + (hsize_t(1) << bits);
      H5Dset_extent(o.set, o.dims.data());
      H5Dclose(o.set);
      if (below(2) == 0) {  // all columns of a row a shape, so that they agree
        for (const Column& other : columns_) {
          Open with = open(file, other);
          with.dims[0] = o.dims[0];
          H5Dset_extent(with.set, with.dims.data());
          H5Dclose(with.set);
        }
      }
    });
    // Rows at the end of what offsets lead to are nobody's.
    const bool nobodys = column.path == "/outline/points" || column.path == "/artwork/thumbnail_png" ||
                         column.path == "/artwork/original" || column.path == "/outline/first_point";
    return {"2^" + std::to_string(bits) + " rows more in " + column.path, nobodys};
  }

  Forgery other_type(const std::string& path) {
    const Column& column = any_column();
    const std::size_t way = below(7);
    change(path, [&](hid_t file) {
      hid_t type = H5Tcopy(way == 0 ? H5T_IEEE_F64LE : way == 1 ? H5T_IEEE_F32BE : H5T_STD_I8LE);
      if (way == 2) H5Tclose(type), type = H5Tcopy(H5T_C_S1), H5Tset_size(type, H5T_VARIABLE);
      if (way == 3) H5Tclose(type), type = H5Tvlen_create(H5T_IEEE_F32LE);
      if (way == 4) H5Tclose(type), type = H5Tcreate(H5T_COMPOUND, 4), H5Tinsert(type, "a", 0, H5T_IEEE_F32LE);
      if (way == 5) H5Tclose(type), type = H5Tcreate(H5T_OPAQUE, io::layout::element_bytes(column));
      if (way == 6) H5Tclose(type), type = H5Tcopy(H5T_STD_REF_OBJ);
      Open o = open(file, column);
      H5Dclose(o.set);
      H5Ldelete(file, column.path.c_str(), H5P_DEFAULT);
      const hid_t space = H5Screate_simple(int(o.dims.size()), o.dims.data(), nullptr);
      const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
      H5Pset_chunk(properties, int(o.chunk.size()), o.chunk.data());
      H5Pset_fletcher32(properties);
      H5Dclose(H5Dcreate2(file, column.path.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT));
      H5Pclose(properties);
      H5Sclose(space);
      H5Tclose(type);
    });
    return {"type of way " + std::to_string(way) + " in " + column.path};
  }

  /// Bytes in one piece, in the header, in another file, or borrowed from one.
  Forgery other_layout(const std::string& path) {
    const Column& column = any_column();
    const std::size_t way = below(4);
    change(path, [&](hid_t file) {
      Open o = open(file, column);
      const hid_t type = H5Dget_type(o.set);
      H5Dclose(o.set);
      H5Ldelete(file, column.path.c_str(), H5P_DEFAULT);
      const hid_t space = H5Screate_simple(int(o.dims.size()), o.dims.data(), nullptr);
      const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
      if (way == 0) H5Pset_layout(properties, H5D_CONTIGUOUS);
      if (way == 1) H5Pset_layout(properties, H5D_COMPACT);
      if (way == 2) H5Pset_external(properties, "/dev/zero", 0, H5F_UNLIMITED);
      if (way == 3) H5Pset_virtual(properties, space, "/dev/zero", column.path.c_str(), space);
      const hid_t made = H5Dcreate2(file, column.path.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
      if (made >= 0) H5Dclose(made);
      H5Pclose(properties);
      H5Sclose(space);
      H5Tclose(type);
    });
    return {"layout of way " + std::to_string(way) + " of " + column.path, is_new(column)};
  }

  static bool is_new(const Column& column) {
    return column.path == "/shapes/part_digest" || column.path == "/artwork/path_from_library" ||
           column.path == "/artwork/sha256";
  }

  Forgery other_link(const std::string& path) {
    const Column& column = any_column();
    const Column& other = any_column();
    const std::size_t way = below(5);
    change(path, [&](hid_t file) {
      const char* name = column.path.c_str();
      H5Ldelete(file, name, H5P_DEFAULT);
      if (way == 1) H5Lcreate_soft("/field/scale", file, name, H5P_DEFAULT, H5P_DEFAULT);
      if (way == 2) H5Lcreate_external("/dev/zero", "/x", file, name, H5P_DEFAULT, H5P_DEFAULT);
      if (way == 3) H5Lcreate_hard(file, other.path.c_str(), file, name, H5P_DEFAULT, H5P_DEFAULT);
      if (way == 4) H5Gclose(H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    });
    return {"link of way " + std::to_string(way) + " for " + column.path + " (" + other.path + ")",
            (way == 0 && is_new(column)) || way == 3};
  }

  /// A number that is none, or out of all proportion, with valid checksums.
  Forgery absurd_number(const std::string& path) {
    const Column& column = any_column();
    return put(path, column, [&](std::uint8_t* at) {
      constexpr float kFloats[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                                   -1e30f, 1e30f, -1, 0, 1e-40f, 20'000, 3};
      const std::int64_t kWholes[] = {-1, 0, 1, INT16_MIN, INT32_MAX, std::int64_t(1) << 40, INT64_MAX, INT64_MIN};
      if (column.element == io::layout::Element::float32) {
        std::memcpy(at, &kFloats[below(std::size(kFloats))], sizeof(float));
      } else {
        const std::int64_t value = kWholes[below(std::size(kWholes))];
        std::memcpy(at, &value, std::min<std::size_t>(sizeof value, io::layout::element_bytes(column)));
      }
    });
  }

  Forgery flipped_content(const std::string& path) {
    const Column& column = any_column();
    return put(path, column, [&](std::uint8_t* at) {
      at[below(io::layout::element_bytes(column))] ^= std::uint8_t(1u << below(8));
    });
  }

  Forgery astray_offset(const std::string& path) {
    std::vector<Column> offsets;
    for (const Column& c : columns_) {
      if (c.element == io::layout::Element::int64) offsets.push_back(c);
    }
    return put(path, offsets[below(offsets.size())], [&](std::uint8_t* at) {
      const std::int64_t value = std::int64_t(below(200'000)) - 1000;
      std::memcpy(at, &value, sizeof value);
    });
  }

  /// Changes an element of the column.
  template <class Change>
  Forgery put(const std::string& path, const Column& column, Change change_element) {
    bool older = false;
    change(path, [&](hid_t file) {
      older = make_older(file);
      if (H5Lexists(file, column.path.c_str(), H5P_DEFAULT) <= 0) return;
      const Open o = open(file, column);
      std::vector<hsize_t> corner(o.dims.size(), 0);
      const std::size_t row = below(o.rows());
      corner[0] = row - row % o.chunk_rows();
      const io::ChunkPacking packing = packing_of(o, column);
      std::vector<std::uint8_t> content = io::read_chunk(o.set, corner, packing, "good");
      const std::size_t element = (row - corner[0]) * io::layout::elements_per_row(column) +
                                  below(io::layout::elements_per_row(column));
      change_element(content.data() + element * io::layout::element_bytes(column));
      const std::vector<std::uint8_t> stored = packed(content, packing);
      H5Dwrite_chunk(o.set, H5P_DEFAULT, 0, corner.data(), stored.size(), stored.data());
      H5Dclose(o.set);
    });
    const bool has_digest = column.path.starts_with("/outline") || column.path.starts_with("/field") ||
                            column.path.starts_with("/levels") || column.path == "/shapes/part_digest";
    return {std::string("a changed element of ") + column.path + (older ? ", without digests" : ""),
            older || !has_digest};
  }

  /// Claims to be huge, or is not RGBA, or brings more along.
  Forgery forged_thumbnail(const std::string& path) {
    const Column column = io::layout::library_columns(5).thumbnail_bytes;
    std::size_t at = 0;
    change(path, [&](hid_t file) {
      const Open o = open(file, column);
      std::vector<hsize_t> corner(1, 0);
      const io::ChunkPacking packing = packing_of(o, column);
      std::vector<std::uint8_t> content = io::read_chunk(o.set, corner, packing, "good");
      at = below(33);  // signature and header of the first one
      content[at] = std::uint8_t(content[at] ^ (1 + below(255)));
      const std::vector<std::uint8_t> stored = packed(content, packing);
      H5Dwrite_chunk(o.set, H5P_DEFAULT, 0, corner.data(), stored.size(), stored.data());
      H5Dclose(o.set);
    });
    return {"byte " + std::to_string(at) + " of a thumbnail", true};
  }

  Forgery forged_attribute(const std::string& path) {
    const char* names[] = {"format", "version", "pad_levels", "pad_delta_tau_rad"};
    const char* name = names[below(4)];
    const std::size_t way = below(4);
    change(path, [&](hid_t file) {
      H5Adelete(file, name);
      if (way == 0) return;
      const hsize_t many = 5000;
      const hid_t space = way == 1 ? H5Screate_simple(1, &many, nullptr) : H5Screate(H5S_SCALAR);
      hid_t type = H5Tcopy(H5T_STD_I32LE);
      if (way == 2) H5Tset_size(type = H5Tcopy(H5T_C_S1), H5T_VARIABLE);
      const hid_t made = H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
      if (way == 3) {
        const int value = int(random_());
        H5Awrite(made, H5T_NATIVE_INT, &value);
      }
      H5Aclose(made);
      H5Tclose(type);
      H5Sclose(space);
    });
    return {std::string("attribute ") + name + " of way " + std::to_string(way)};
  }

  Forgery cut(const std::string& path) {
    const auto size = std::filesystem::file_size(path);
    const auto left = size * below(1000) / 1000;
    std::filesystem::resize_file(path, left);
    return {"cut to " + std::to_string(left) + " of " + std::to_string(size) + " bytes"};
  }

  /// Anywhere in the file; what lies in unused bytes means nothing.
  Forgery flipped_bytes(const std::string& path) {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    const auto size = std::filesystem::file_size(path);
    for (std::size_t i = 1 + below(8); i > 0; --i) {
      file.seekp(std::streamoff(below(2) == 0 ? below(8192) : below(size)));
      file.put(char(random_()));
    }
    return {"some bytes of the file", false};
  }

  std::mt19937 random_;
  std::vector<Column> columns_;
};

}  // namespace tessera::test
