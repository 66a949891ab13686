#include "artwork/sandbox/drawer_landlock.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>

namespace tessera {
namespace {

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

/// The kernel's version of Landlock; less than 1 where it has none.
long landlock_version() { return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION); }

/// All rights to files that this version can forbid; a bit unknown to the kernel would be an error. Those of later
/// versions are written as numbers, since the headers of older systems lack them.
__u64 all_access(long version) {
  constexpr __u64 kFirstVersion = 2 * LANDLOCK_ACCESS_FS_MAKE_SYM - 1;
  constexpr __u64 kRefer = 1 << 13;     // since version 2
  constexpr __u64 kTruncate = 1 << 14;  // since version 3
  return kFirstVersion | (version >= 2 ? kRefer : 0) | (version >= 3 ? kTruncate : 0);
}

/// Allows reading a path; a path that does not exist needs no rule. False where the kernel refuses the rule.
bool allow_reading(const Descriptor& rules, const std::string& path) {
  const Descriptor place(::open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat status {};
  if (place.number() < 0 || ::fstat(place.number(), &status) != 0) return true;
  landlock_path_beneath_attr rule{};
  rule.parent_fd = place.number();
  rule.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
  if (S_ISDIR(status.st_mode)) rule.allowed_access |= LANDLOCK_ACCESS_FS_READ_DIR;
  return ::syscall(SYS_landlock_add_rule, rules.number(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
}

}  // namespace

LayerState confine_to_files(const std::vector<std::string>& readable) {
  const long version = landlock_version();
  if (version < 1) return LayerState::missing;
  landlock_ruleset_attr attributes{};
  attributes.handled_access_fs = all_access(version);
  const Descriptor rules(::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes.handled_access_fs, 0));
  const auto allow = [&](const std::string& path) { return allow_reading(rules, path); };
  const bool holds = rules.number() >= 0 && std::all_of(readable.begin(), readable.end(), allow) &&
                     ::syscall(SYS_landlock_restrict_self, rules.number(), 0) == 0;
  return holds ? LayerState::holds : LayerState::failed;
}

}  // namespace tessera
