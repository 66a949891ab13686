#include "files/child_process.h"

#include <fcntl.h>
#include <spawn.h>

#include <cerrno>
#include <csignal>

namespace tessera {
namespace {

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// The two sets of settings for posix_spawn.
class SpawnSettings {
 public:
  explicit SpawnSettings(const std::vector<int>& descriptors) {
    ::posix_spawn_file_actions_init(&actions);
    const int count = int(descriptors.size());
    for (int i = 0; i < count; ++i) {
      const int descriptor = descriptors[std::size_t(i)];
      if (descriptor != kNoDescriptor) ::posix_spawn_file_actions_adddup2(&actions, descriptor, i);
    }
    for (int i = 0; i < count; ++i) {
      if (descriptors[std::size_t(i)] != kNoDescriptor) continue;
      ::posix_spawn_file_actions_addopen(&actions, i, "/dev/null", O_RDWR, 0);
    }
    ::posix_spawn_file_actions_addclosefrom_np(&actions, count);
    ::posix_spawnattr_init(&attributes);
    sigset_t none, all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &all);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSettings() {
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
};

}  // namespace

pid_t start_child(const std::string& program, std::vector<std::string> words, std::vector<std::string> environment,
                  const std::vector<int>& descriptors) {
  const SpawnSettings settings(descriptors);
  pid_t child = -1;
  const int error = ::posix_spawn(&child, program.c_str(), &settings.actions, &settings.attributes,
                                  pointers_to(words).data(), pointers_to(environment).data());
  if (error == 0) return child;
  errno = error;
  return -1;
}

}  // namespace tessera
