#include "files/own_program.h"

#include <filesystem>
#include <system_error>

#include "core/base/error.h"

namespace tessera {

std::string own_program() {
  constexpr const char* kLink = "/proc/self/exe";
  std::error_code error;
  const std::filesystem::path path = std::filesystem::read_symlink(kLink, error);
  if (error)
    throw EnvironmentError(std::string("cannot tell where this program lies: ") + kLink + ": " + error.message());
  return path.string();
}

std::string program_beside_own(const std::string& name) {
  return (std::filesystem::path(own_program()).parent_path() / name).string();
}

}  // namespace tessera
