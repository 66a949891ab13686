#include "artwork/drawers/drawer_program.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "core/base/error.h"
#include "files/own_program.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

constexpr char kName[] = "tessera-drawer";

bool can_be_run(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

/// The value of the environment variable TESSERA_DRAWER; null where it is not set or empty.
const char* named_by_user() {
  const char* given = std::getenv("TESSERA_DRAWER");
  return given && *given ? given : nullptr;
}

fs::path folder_of_program() {
  try {
    return fs::path(own_program()).parent_path();
  } catch (const EnvironmentError& error) {
    throw EnvironmentError(std::string(error.what()) + "; TESSERA_DRAWER=FILE says where tessera-drawer lies");
  }
}

}  // namespace

std::string drawer_program() {
  if (named_by_user()) return drawer_program_among({});  // without /proc, which own_program() needs
  const fs::path folder = folder_of_program();
  return drawer_program_among({folder / kName, folder.parent_path() / "libexec" / "tessera" / kName});
}

std::string drawer_program_among(const std::vector<std::string>& files) {
  if (const char* given = named_by_user()) {
    if (can_be_run(given)) return given;
    throw EnvironmentError(std::string("TESSERA_DRAWER: found ") + given + ", which is no program that can be run");
  }
  std::string places;
  for (const std::string& file : files) {
    if (can_be_run(file)) return file;
    places += (places.empty() ? "" : " and ") + file;
  }
  throw EnvironmentError("the program tessera-drawer, which reads drawings, is missing: looked for " + places +
                         "; TESSERA_DRAWER=FILE names another place");
}

}  // namespace tessera
