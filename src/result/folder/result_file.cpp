#include "result/folder/result_file.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "files/regular_file.h"

namespace tessera {

namespace fs = std::filesystem;

std::string path_in_result(const std::string& dir, const std::string& name) { return (fs::path(dir) / name).string(); }

bool is_in_result(const std::string& dir, const std::string& name) {
  std::error_code error;
  const fs::file_status status = fs::status(fs::path(dir) / name, error);
  if (status.type() == fs::file_type::not_found) return false;
  if (error) throw EnvironmentError(path_in_result(dir, name) + ": cannot be read: " + error.message());
  return true;
}

FileBlocks open_result_file(const std::string& dir, const std::string& name, std::size_t most_bytes) {
  const std::string path = path_in_result(dir, name);
  if (!is_in_result(dir, name)) {
    throw InputError(path + ": not found; allowed: the folder of a result of tessera collage");
  }
  FileDescriptor file(-1);
  try {
    file = open_regular_file(path);
  } catch (const InputError& error) {
    throw EnvironmentError(error.what());
  }
  return FileBlocks(std::move(file), path, most_bytes);
}

std::string read_result_file(const std::string& dir, const std::string& name, std::size_t most_bytes) {
  FileBlocks blocks = open_result_file(dir, name, most_bytes);
  std::string bytes;
  for (std::span<const char> block = blocks.next(); !block.empty(); block = blocks.next())
    bytes.append(block.begin(), block.end());
  return bytes;
}

std::string read_result_json(const std::string& dir, const std::string& name, const JsonBounds& bounds) {
  std::string text = read_result_file(dir, name);
  try {
    check_json(text, bounds);
  } catch (const InputError& error) {
    throw InputError(path_in_result(dir, name) + ": " + error.what());
  }
  return text;
}

}  // namespace tessera
