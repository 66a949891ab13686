#include "io/drawing/drawer_files.h"

#include <fcntl.h>
#include <fontconfig/fontconfig.h>
#include <link.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string_view>

namespace tessera::io {
namespace {

using Paths = std::vector<std::string>;

/// Debian's, and what the C library, thread pools and sanitizers ask about the machine. The rest of /proc and /etc stays
/// shut: other processes' environments, passwords.
constexpr const char* kOfSystem[] = {"/usr",
                                     "/lib",
                                     "/lib64",
                                     "/etc/fonts",
                                     "/etc/ld.so.cache",
                                     "/etc/localtime",
                                     "/var/cache/fontconfig",
                                     "/proc/self",
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

/// Of a variable of the XDG base directories, or its default in the home folder. Empty: there is neither.
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

/// Of a list with colons between the folders.
void add_below_each(const std::string& folders, std::initializer_list<const char*> names, Paths& paths) {
  for (std::size_t from = 0; from <= folders.size();) {
    const std::size_t to = std::min(folders.find(':', from), folders.size());
    add_below(folders.substr(from, to - from), names, paths);
    from = to + 1;
  }
}

/// Never the home folder itself.
void add_users_own(Paths& paths) {
  add_below(user_folder("XDG_DATA_HOME", ".local/share"), {"fonts", "mime"}, paths);
  add_below(user_folder("XDG_CONFIG_HOME", ".config"), {"fontconfig"}, paths);
  add_below(user_folder("XDG_CACHE_HOME", ".cache"), {"fontconfig"}, paths);
  add_below(environment("HOME"), {".fonts", ".fonts.conf", ".fonts.conf.d"}, paths);
  add_below_each(environment("XDG_DATA_DIRS"), {"fonts", "mime"}, paths);
  for (const char* variable : {"FONTCONFIG_FILE", "FONTCONFIG_PATH"}) paths.push_back(environment(variable));
  if (const std::string list = environment("GDK_PIXBUF_MODULE_FILE"); !list.empty()) {
    paths.push_back(std::filesystem::path(list).parent_path());  // the loaders lie below it
  }
}

void add_all(FcStrList* list, Paths& paths) {
  if (!list) return;
  while (const FcChar8* path = FcStrListNext(list)) paths.emplace_back(reinterpret_cast<const char*>(path));
  FcStrListDone(list);
}

/// As the configuration says; the fonts themselves are not looked at yet.
void add_fonts(Paths& paths) {
  const std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)> config(FcInitLoadConfig(), FcConfigDestroy);
  if (!config) return;
  add_all(FcConfigGetFontDirs(config.get()), paths);
  add_all(FcConfigGetConfigFiles(config.get()), paths);
  add_all(FcConfigGetCacheDirs(config.get()), paths);
}

/// Where this process has its libraries from, plugins lie below: a cluster's modules are not in /usr.
int add_library_folder(dl_phdr_info* library, std::size_t, void* paths) {
  const std::string_view file(library->dlpi_name);
  if (file.starts_with('/')) static_cast<Paths*>(paths)->push_back(std::filesystem::path(file).parent_path());
  return 0;
}

class Descriptor {
 public:
  explicit Descriptor(long number) : number_(int(number)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }

 private:
  int number_;
};

/// All that the first version of Landlock knows: its bits up to the last.
constexpr __u64 kAllAccess = 2 * LANDLOCK_ACCESS_FS_MAKE_SYM - 1;

/// What is not there need not be allowed.
void allow_reading(const Descriptor& rules, const std::string& path) {
  const Descriptor place(::open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat status {};
  if (place.number() < 0 || ::fstat(place.number(), &status) != 0) return;
  landlock_path_beneath_attr rule{};
  rule.parent_fd = place.number();
  rule.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
  if (S_ISDIR(status.st_mode)) rule.allowed_access |= LANDLOCK_ACCESS_FS_READ_DIR;
  ::syscall(SYS_landlock_add_rule, rules.number(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
}

}  // namespace

std::vector<std::string> files_of_decoders() {
  Paths paths(std::begin(kOfSystem), std::end(kOfSystem));
  add_users_own(paths);
  add_fonts(paths);
  ::dl_iterate_phdr(add_library_folder, &paths);
  std::sort(paths.begin(), paths.end());
  paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
  std::erase(paths, "");
  return paths;
}

bool confine_to_files(const std::vector<std::string>& readable) {
  landlock_ruleset_attr attributes{};
  attributes.handled_access_fs = kAllAccess;
  const Descriptor rules(::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0));
  if (rules.number() < 0) return false;
  for (const std::string& path : readable) allow_reading(rules, path);
  return ::syscall(SYS_landlock_restrict_self, rules.number(), 0) == 0;
}

}  // namespace tessera::io
