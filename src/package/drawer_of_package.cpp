#include "package/drawer_of_package.h"

#include <dlfcn.h>

#include <filesystem>

#include "artwork/drawers/drawer_program.h"
#include "core/base/error.h"

namespace tessera::matching {
namespace {

namespace fs = std::filesystem;

fs::path folder_of_library() {
  Dl_info found{};
  std::error_code error;
  if (::dladdr(reinterpret_cast<const void*>(&drawer_of_package), &found) != 0 && found.dli_fname) {
    const fs::path file = fs::canonical(found.dli_fname, error);
    if (!error) return file.parent_path();
  }
  throw EnvironmentError(
      "cannot tell where libtessera-matching.so lies; TESSERA_DRAWER=FILE says where tessera-drawer is");
}

}  // namespace

std::string drawer_of_package() {
  // TESSERA_DRAWER_FROM_LIBRARY: the path of the installed drawer, relative to the library's folder.
  return drawer_program_among({(folder_of_library() / TESSERA_DRAWER_FROM_LIBRARY).lexically_normal().string()});
}

}  // namespace tessera::matching
