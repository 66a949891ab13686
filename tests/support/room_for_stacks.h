// Simulates a limit on the number of threads for this process only.
#pragma once

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>

namespace tessera::test {

/// While an object of this class lives, the process can start only `count` threads. Each thread's stack is so large that the address space
/// has room for `count` of them.
/// Stacks of ended threads have another size, so the system does not use them again.
class RoomForStacks {
 public:
  explicit RoomForStacks(int count) {
    ::pthread_getattr_default_np(&usual_);
    pthread_attr_t large;
    ::pthread_getattr_default_np(&large);
    ::pthread_attr_setstacksize(&large, kStack_bytes);
    ::pthread_setattr_default_np(&large);
    ::pthread_attr_destroy(&large);
    const std::size_t bytes = std::size_t(count) * kStack_bytes + kStack_bytes / 2;
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    ::getrlimit(RLIMIT_AS, &before_);
    const rlimit little{pages * std::size_t(::sysconf(_SC_PAGESIZE)) + bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_AS, &little);
  }
  ~RoomForStacks() {
    ::setrlimit(RLIMIT_AS, &before_);
    ::pthread_setattr_default_np(&usual_);
    ::pthread_attr_destroy(&usual_);
  }
  RoomForStacks(const RoomForStacks&) = delete;
  RoomForStacks& operator=(const RoomForStacks&) = delete;

 private:
  static constexpr std::size_t kStack_bytes = std::size_t(512) << 20;

  pthread_attr_t usual_{};
  rlimit before_{};
};

}  // namespace tessera::test
