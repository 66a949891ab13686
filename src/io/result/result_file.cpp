#include "io/result/result_file.h"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "io/regular_file.h"

namespace tessera::io {

namespace fs = std::filesystem;

std::string path_in_result(const std::string& dir, const std::string& name) { return (fs::path(dir) / name).string(); }

bool is_in_result(const std::string& dir, const std::string& name) {
  std::error_code error;
  const fs::file_status status = fs::status(fs::path(dir) / name, error);
  if (status.type() == fs::file_type::not_found) return false;
  if (error) throw EnvironmentError(path_in_result(dir, name) + ": cannot be read: " + error.message());
  return true;
}

std::string read_result_file(const std::string& dir, const std::string& name) {
  const std::string path = path_in_result(dir, name);
  if (!is_in_result(dir, name)) {
    throw InputError(path + ": not found; allowed: the folder of a result of tessera collage");
  }
  try {
    const std::vector<std::uint8_t> bytes = read_regular_file(path, std::numeric_limits<std::size_t>::max());
    return {bytes.begin(), bytes.end()};
  } catch (const InputError& error) {
    throw EnvironmentError(error.what());
  }
}

}  // namespace tessera::io
