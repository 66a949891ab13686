#include "io/library/library_open.h"

#include <unistd.h>

#include <array>
#include <filesystem>
#include <string_view>

#include "core/base/error.h"
#include "io/library/hdf5_attributes.h"
#include "io/library/library_check.h"
#include "io/library/library_layout.h"
#include "io/regular_file.h"

namespace tessera::io {
namespace {

/// HDF5 1.10 parses older formats without checksums, and not safely where they are damaged. Ours has superblock 3.
void check_superblock(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(path + ": no such file, or not readable");
  const FileDescriptor file = open_regular_file(path);  // a pipe or device would never end
  std::array<char, 9> head{};
  const ssize_t got = ::pread(file.number(), head.data(), head.size(), 0);
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
  if (got != ssize_t(head.size()) || std::string_view(head.data(), 8) != kSignature) {
    throw InputError(path + ": not a library: not an HDF5 file");
  }
  if (head[8] != 3) throw InputError(path + ": not a library: an HDF5 file of an older format");
}

}  // namespace

Hdf5Handle open_library(const std::string& path) {
  check_superblock(path);
  // No code from outside: filters of a foreign file are not searched for.
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

}  // namespace tessera::io
