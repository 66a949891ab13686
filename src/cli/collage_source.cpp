#include "cli/collage_source.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "core/base/error.h"
#include "files/regular_file.h"
#include "library/artwork_files.h"
#include "terminal/shell_word.h"

namespace tessera::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHdf5Signature("\x89HDF\r\n\x1a\n", 8);

/// Whether the file is HDF5. Also false where it cannot be read: the reader of the job reports why.
bool is_hdf5(const std::string& path) {
  try {
    std::array<std::uint8_t, kHdf5Signature.size()> first = {};
    const std::size_t count = read_at(path, open_regular_file(path), 0, first);
    return count == first.size() && std::equal(first.begin(), first.end(), kHdf5Signature.begin(),
                                               [](std::uint8_t a, char b) { return a == std::uint8_t(b); });
  } catch (const InputError&) {
    return false;
  }
}

[[noreturn]] void refuse_result(const std::string& path) {
  const std::string folder = shell_word(path);
  throw InputError(path + ": found the folder of a result, allowed: a job, or a folder of drawings; tessera draw " +
                   folder + " draws its pictures again, tessera refine " + folder +
                   " changes it (see tessera refine --help), tessera collage " +
                   shell_word(fs::path(path) / "job.toml") + " makes it again");
}

[[noreturn]] void refuse_picture(const std::string& path) {
  const std::string picture = shell_word(path);
  throw InputError(path +
                   ": found a picture, allowed: a job, or a folder of drawings; tessera collage FOLDER --canvas " +
                   picture + " fills its shape with the drawings in FOLDER, tessera mosaic " + picture +
                   " LIB.h5 shows it by the colours of a library's drawings");
}

}  // namespace

CollageSource collage_source(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    if (is_result_folder(path)) refuse_result(path);
    return CollageSource::drawings;
  }
  if (!fs::exists(path, error) && fs::path(path).extension() != ".toml")
    throw InputError(path +
                     ": no such file or folder; allowed: a job file, a folder of drawings, or a library; a name with "
                     "spaces needs quotes");
  if (has_artwork_name(path)) refuse_picture(path);
  return is_hdf5(path) ? CollageSource::library : CollageSource::job;
}

}  // namespace tessera::cli
