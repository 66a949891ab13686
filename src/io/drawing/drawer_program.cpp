#include "io/drawing/drawer_program.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "core/base/error.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

constexpr char kName[] = "tessera-drawer";

bool can_be_run(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

}  // namespace

std::string drawer_program() {
  if (const char* given = std::getenv("TESSERA_DRAWER"); given && *given) {
    if (can_be_run(given)) return given;
    throw EnvironmentError(std::string("TESSERA_DRAWER: found ") + given + ", which is no program that can be run");
  }
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path beside = folder / kName;
  const fs::path installed = folder.parent_path() / "libexec" / "tessera" / kName;
  for (const fs::path& file : {beside, installed}) {
    if (can_be_run(file)) return file;
  }
  throw EnvironmentError("the program tessera-drawer, which reads drawings, is missing: looked for " + beside.string() +
                         " and " + installed.string() + "; TESSERA_DRAWER=FILE names another place");
}

}  // namespace tessera::io
