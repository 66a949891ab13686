// Checkpoints as an attacker makes them: a valid file, changed at one place, and mostly sealed again. All choices follow from a seed.
#pragma once

#include <hdf5.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "checkpoint/checkpoint_columns.h"
#include "checkpoint/checkpoint_seal.h"
#include "library/hdf5/hdf5_handles.h"
#include "support/hostile_file.h"

namespace tessera::test {

class CheckpointForger {
 public:
  explicit CheckpointForger(std::uint32_t seed) : random_(seed) {
    CheckpointColumns columns;
    each_column(columns, [&](const char* path, auto&, int, const char*, const char*) { paths_.push_back(path); });
  }

  static constexpr int kKinds = 8;

  Forgery forge(const std::string& path, int kind) {
    switch (kind) {
      case 0: return flipped(path, false);
      case 1: return flipped(path, true);
      case 2: return cut(path);
      case 3: return other_seal(path);
      case 4: return other_data_set(path);
      case 5: return absurd_numbers(path);
      case 6: return other_length(path);
      default: return other_link(path);
    }
  }

 private:
  std::size_t below(std::size_t end) { return std::size_t(random_() % end); }
  const std::string& any_path() { return paths_[below(paths_.size())]; }

  template <class Change>
  static void change(const std::string& path, Change change) {
    const Hdf5Silence silence;  // objects that cannot be made are then missing
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18);
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, access);
    if (file < 0) throw std::runtime_error("cannot open " + path);
    change(file);
    H5Fclose(file);
    H5Pclose(access);
    seal_again(path);
  }

  static std::vector<std::uint8_t> bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  static void write(const std::string& path, const std::vector<std::uint8_t>& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  }

  static void seal_again(const std::string& path) {
    std::vector<std::uint8_t> bytes = bytes_of(path);
    seal_checkpoint(bytes);
    write(path, bytes);
  }

  Forgery flipped(const std::string& path, bool sealed) {
    std::vector<std::uint8_t> bytes = bytes_of(path);
    for (std::size_t i = 1 + below(8); i > 0; --i) {
      std::uint8_t& byte = bytes[sealed ? kSealBytes + below(bytes.size() - kSealBytes) : below(bytes.size())];
      byte = std::uint8_t(byte ^ (1 + below(255)));
    }
    write(path, bytes);
    if (sealed) seal_again(path);
    return {sealed ? "some bytes, sealed again" : "some bytes", sealed};
  }

  Forgery cut(const std::string& path) {
    const auto size = std::filesystem::file_size(path);
    const std::size_t left = below(size);
    std::filesystem::resize_file(path, left);
    const bool sealed = left > kSealBytes && below(2) == 0;
    if (sealed) seal_again(path);
    // The zeros that fill the file's end belong to no object.
    return {"cut to " + std::to_string(left) + (sealed ? ", sealed again" : ""), sealed};
  }

  Forgery other_seal(const std::string& path) {
    std::vector<std::uint8_t> bytes = bytes_of(path);
    const std::size_t at = below(80);
    bytes[at] = std::uint8_t(bytes[at] ^ (1 + below(255)));
    write(path, bytes);
    return {"byte " + std::to_string(at) + " of the seal"};
  }

  /// Replaces a data set by one with another type, layout or filter.
  Forgery other_data_set(const std::string& path) {
    const std::string name = any_path();
    const std::size_t way = below(8);
    change(path, [&](hid_t file) {
      const hid_t old = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
      const hid_t space = H5Dget_space(old);
      hid_t type = H5Dget_type(old);
      H5Dclose(old);
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      const hsize_t chunk[2] = {1, 1};
      const int rank = H5Sget_simple_extent_ndims(space);
      const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
      hid_t extent = H5Scopy(space);
      if (way < 3) H5Pset_chunk(properties, rank, chunk);
      if (way == 1 || way == 2) H5Pset_deflate(properties, 9);
      if (way == 2) H5Pset_deflate(properties, 9);
      if (way == 3) H5Pset_layout(properties, H5D_COMPACT);
      if (way == 4) H5Pset_external(properties, "/dev/zero", 0, H5F_UNLIMITED);
      if (way == 5) H5Pset_virtual(properties, space, "/dev/zero", "/x", space);
      if (way == 6) type = H5Tvlen_create(H5T_IEEE_F32LE);
      if (way == 7) {
        hsize_t dims[2] = {hsize_t(1) << (20 + below(40)), 4};
        extent = H5Screate_simple(rank, dims, nullptr);
      }
      const hid_t made = H5Dcreate2(file, name.c_str(), type, extent, H5P_DEFAULT, properties, H5P_DEFAULT);
      if (made >= 0) H5Dclose(made);
      H5Sclose(extent);
      H5Sclose(space);
      H5Pclose(properties);
    });
    return {"data set of way " + std::to_string(way) + " for " + name};
  }

  Forgery absurd_numbers(const std::string& path) {
    const std::string name = any_path();
    change(path, [&](hid_t file) {
      const hid_t set = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
      std::vector<std::uint8_t> bytes(std::size_t(H5Dget_storage_size(set)));
      const hid_t type = H5Dget_type(set);
      if (!bytes.empty()) {
        H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
        const std::size_t element = H5Tget_size(type);
        const std::uint64_t kWords[] = {0,
                                        1,
                                        ~0ull,
                                        0x7fc000007fc00000ull,
                                        0x7f8000007f800000ull,
                                        0x8000000080000000ull,
                                        0x7fffffff7fffffffull,
                                        0x4f0000004f000000ull};
        for (std::size_t i = 1 + below(3); i > 0; --i)
          std::memcpy(bytes.data() + below(bytes.size() / element) * element, &kWords[below(8)], element);
        H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
      }
      H5Tclose(type);
      H5Dclose(set);
    });
    return {"numbers of " + name, true};
  }

  Forgery other_length(const std::string& path) {
    const std::string name = any_path();
    change(path, [&](hid_t file) {
      const hid_t old = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
      const hid_t space = H5Dget_space(old);
      const hid_t type = H5Dget_type(old);
      hsize_t dims[2] = {0, 1};
      const int rank = H5Sget_simple_extent_dims(space, dims, nullptr);
      H5Dclose(old);
      H5Sclose(space);
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      const hsize_t lengths[] = {0, dims[0] + 1, dims[0] / 2, 3'000'000};
      dims[0] = lengths[below(4)];
      const std::vector<std::uint8_t> zeros(std::size_t(dims[0] * dims[1]) * H5Tget_size(type));
      const hid_t longer = H5Screate_simple(rank, dims, nullptr);
      const hid_t made = H5Dcreate2(file, name.c_str(), type, longer, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
      H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
      H5Dclose(made);
      H5Sclose(longer);
      H5Tclose(type);
    });
    return {"another length of " + name, true};
  }

  Forgery other_link(const std::string& path) {
    const std::string name = any_path();
    const std::string other = any_path();
    const std::size_t way = below(5);
    change(path, [&](hid_t file) {
      if (way == 3 && name == other) return;
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      if (way == 1) H5Lcreate_soft("/digests", file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      if (way == 2) H5Lcreate_external("/dev/zero", "/x", file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      if (way == 3) H5Lcreate_hard(file, other.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      if (way == 4) H5Gclose(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    });
    return {"link of way " + std::to_string(way) + " for " + name, way == 3};
  }

  std::mt19937 random_;
  std::vector<std::string> paths_;
};

}  // namespace tessera::test
