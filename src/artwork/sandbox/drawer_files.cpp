#include "artwork/sandbox/drawer_files.h"

#include <fontconfig/fontconfig.h>
#include <link.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>

namespace tessera {
namespace {

using Paths = std::vector<std::string>;

/// Debian's folders, and what the C library, thread pools and sanitizers read about the machine and their own process.
/// The rest of /proc and /etc stays closed: environments, connections, passwords.
constexpr const char* kOfSystem[] = {"/usr",
                                     "/lib",
                                     "/lib64",
                                     "/etc/fonts",
                                     "/etc/ld.so.cache",
                                     "/etc/localtime",
                                     "/var/cache/fontconfig",
                                     "/proc/self/cgroup",
                                     "/proc/self/maps",
                                     "/proc/self/statm",
                                     "/proc/self/status",
                                     "/proc/cpuinfo",
                                     "/proc/meminfo",
                                     "/proc/filesystems",
                                     "/proc/sys/vm",
                                     "/sys/devices/system",
                                     "/sys/kernel/mm",
                                     "/sys/fs/cgroup",
                                     "/dev/null",
                                     "/dev/urandom"};

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// The folder in a variable of the XDG base directories, or its default in the home folder. Empty where there is
/// neither.
std::string user_folder(const char* variable, const char* in_home) {
  if (const std::string given = environment(variable); !given.empty()) return given;
  const std::string home = environment("HOME");
  return home.empty() ? "" : home + "/" + in_home;
}

void add_below(const std::string& folder, std::initializer_list<const char*> names, Paths& paths) {
  for (const char* name : names) {
    if (!folder.empty()) paths.push_back(folder + "/" + name);
  }
}

/// The parts between the separators.
Paths parts_of(const std::string& list, const char* separators) {
  Paths parts;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t to = std::min(list.find_first_of(separators, from), list.size());
    parts.push_back(list.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

void add_users_own(Paths& paths) {
  add_below(user_folder("XDG_DATA_HOME", ".local/share"), {"fonts", "mime"}, paths);
  add_below(user_folder("XDG_CONFIG_HOME", ".config"), {"fontconfig"}, paths);
  add_below(user_folder("XDG_CACHE_HOME", ".cache"), {"fontconfig"}, paths);
  add_below(environment("HOME"), {".fonts", ".fonts.conf", ".fonts.conf.d"}, paths);
  for (const std::string& folder : parts_of(environment("XDG_DATA_DIRS"), ":")) {
    add_below(folder, {"fonts", "mime"}, paths);
  }
}

/// Adds the list of gdk-pixbuf's loaders, each loader, and its folder, which has what the loader needs. A loader stands
/// alone in its line, in quotes.
void add_image_loaders(Paths& paths) {
  const std::string list = environment("GDK_PIXBUF_MODULE_FILE");
  paths.push_back(list);
  std::ifstream lines(list);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("\"/") || line.find('"', 1) != line.size() - 1) continue;
    const std::filesystem::path loader = line.substr(1, line.size() - 2);
    paths.push_back(loader);
    paths.push_back(loader.parent_path());
  }
}

void add_all(FcStrList* list, Paths& paths) {
  if (!list) return;
  while (const FcChar8* path = FcStrListNext(list)) paths.emplace_back(reinterpret_cast<const char*>(path));
  FcStrListDone(list);
}

/// Adds the folders of fonts in the configuration; does not read the fonts themselves.
void add_fonts(Paths& paths) {
  const std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)> config(FcInitLoadConfig(), FcConfigDestroy);
  if (!config) return;
  add_all(FcConfigGetFontDirs(config.get()), paths);
  add_all(FcConfigGetConfigFiles(config.get()), paths);
  add_all(FcConfigGetCacheDirs(config.get()), paths);
}

/// Adds a library's folder, as plug-ins lie below it: modules of a cluster are not in /usr.
int add_library_folder(dl_phdr_info* library, std::size_t, void* paths) {
  const std::string_view file(library->dlpi_name);
  if (file.starts_with('/')) static_cast<Paths*>(paths)->push_back(std::filesystem::path(file).parent_path());
  return 0;
}

/// Adds the folders of this process' libraries, and those in which later ones are searched.
void add_libraries(Paths& paths) {
  ::dl_iterate_phdr(add_library_folder, &paths);
  for (const std::string& folder : parts_of(environment("LD_LIBRARY_PATH"), ":;")) paths.push_back(folder);
}

/// The paths that exist, with links resolved, without the root, the home folder, and folders above the home folder:
/// whatever a variable or a configuration names, a drawing must not read the rest of these.
Paths without_home(const Paths& paths) {
  std::error_code error;
  const std::filesystem::path home = std::filesystem::weakly_canonical(environment("HOME"), error) / "";
  Paths kept;
  for (const std::string& path : paths) {
    const std::filesystem::path place = path.empty() ? "" : std::filesystem::canonical(path, error);
    const bool holds_home = home.native().starts_with((place / "").native());
    if (!place.empty() && !error && !holds_home && place != "/") kept.push_back(place);
  }
  return kept;
}

}  // namespace

std::vector<std::string> files_of_decoders() {
  Paths found;
  add_users_own(found);
  add_image_loaders(found);
  add_fonts(found);
  add_libraries(found);
  Paths paths = without_home(found);
  // The system's folders stay, whatever they hold: some daemon accounts have their home folder in /usr.
  paths.insert(paths.end(), std::begin(kOfSystem), std::end(kOfSystem));
  std::sort(paths.begin(), paths.end());
  paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
  return paths;
}

}  // namespace tessera
