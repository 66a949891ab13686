#include "library/storage/library_open.h"

#include <array>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "core/base/error.h"
#include "files/regular_file.h"
#include "library/hdf5/hdf5_attributes.h"
#include "library/storage/library_check.h"
#include "library/storage/library_layout.h"

namespace tessera {
namespace {

/// The first bytes of an HDF5 file of our format.
constexpr std::string_view kHdf5Signature = "\x89HDF\r\n\x1a\n";
constexpr std::size_t kVersionAt = 8;      // of the superblock; one byte
constexpr std::size_t kOffsetBytesAt = 9;  // how many bytes an address has; one byte
constexpr std::size_t kEndAt = 28;         // the address at which the file ends, where addresses have eight bytes
constexpr std::uint8_t kOurVersion = 3;

using Superblock = std::array<std::uint8_t, 48>;

/// Throws where the file is cut off. HDF5 reports this only in numbers and obscure words.
void check_is_whole(const std::string& path, const FileDescriptor& file, const Superblock& head, std::size_t got) {
  const std::uint64_t bytes = size_of(path, file);
  std::uint64_t all = head.size();
  if (got == head.size() && head[kOffsetBytesAt] == sizeof all) std::memcpy(&all, &head[kEndAt], sizeof all);
  if (bytes >= all) return;
  throw InputError(path + ": cut off: " + std::to_string(bytes) + " of " + std::to_string(all) +
                   " bytes are there; copy it again, or build it again with tessera library build");
}

/// Refuses older HDF5 formats: HDF5 1.10 reads them without checksums, and not safely where they are damaged.
void check_superblock(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(path + ": no such file, or not readable");
  const FileDescriptor file = open_regular_file(path);
  Superblock head{};
  const std::size_t got = read_at(path, file, 0, head);
  if (std::string_view(reinterpret_cast<const char*>(head.data()), kHdf5Signature.size()) != kHdf5Signature)
    throw InputError(path + ": not a library: not an HDF5 file");
  if (got > kVersionAt && head[kVersionAt] != kOurVersion)
    throw InputError(path + ": not a library: an HDF5 file of an older format");
  check_is_whole(path, file, head, got);
}

}  // namespace

Hdf5Handle open_library(const std::string& path) {
  check_superblock(path);
  // Keeps HDF5 from loading foreign code: it must not search for filters that a file names.
  H5PLset_loading_state(0);
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), "file");
  hdf5_checked(H5Pset_file_locking(access.get(), false, true), "file");  // often missing on cluster file systems
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), "damaged or not complete"};
}

PadParameters read_library_header(hid_t file) {
  if (H5Aexists(file, layout::kFormatAttribute) <= 0 ||
      read_text_attribute(file, layout::kFormatAttribute) != layout::kFormat) {
    throw Hdf5Error("not a library: an HDF5 file of another kind");
  }
  const int version = read_int_attribute(file, layout::kVersionAttribute);
  if (version != layout::kVersion) {
    throw Hdf5Error("library format version " + std::to_string(version) + ", this program reads version " +
                    std::to_string(layout::kVersion) + kBuildAgain);
  }
  PadParameters pad;
  pad.levels = read_int_attribute(file, layout::kPadLevelsAttribute);
  pad.delta_tau = read_float_attribute(file, layout::kDeltaTauAttribute);
  if (pad.levels < 2 || pad.levels > kMaxPadLevels || !all_within(&pad.delta_tau, 1, 1e-3f, 10.f)) {
    throw Hdf5Error("the PAD parameters are out of range");
  }
  return pad;
}

}  // namespace tessera
