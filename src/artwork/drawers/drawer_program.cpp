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

fs::path folder_of_program() {
  try {
    return fs::path(own_program()).parent_path();
  } catch (const EnvironmentError& error) {
    throw EnvironmentError(std::string(error.what()) + "; TESSERA_DRAWER=FILE says where tessera-drawer lies");
  }
}

}  // namespace

std::string drawer_program() {
  if (const char* given = std::getenv("TESSERA_DRAWER"); given && *given) {
    if (can_be_run(given)) return given;
    throw EnvironmentError(std::string("TESSERA_DRAWER: found ") + given + ", which is no program that can be run");
  }
  const fs::path folder = folder_of_program();
  const fs::path beside = folder / kName;
  const fs::path installed = folder.parent_path() / "libexec" / "tessera" / kName;
  for (const fs::path& file : {beside, installed}) {
    if (can_be_run(file)) return file;
  }
  throw EnvironmentError("the program tessera-drawer, which reads drawings, is missing: looked for " + beside.string() +
                         " and " + installed.string() + "; TESSERA_DRAWER=FILE names another place");
}

}  // namespace tessera
