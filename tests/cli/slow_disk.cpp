// A library that makes the disk slow for the program that preloads it. Each flush takes SLOW_FLUSH_MS longer, each renaming SLOW_RENAME_MS.
// Flushes of several threads wait at the same time.
#include <sys/syscall.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace {

void wait(const char* variable) {
  const char* const text = std::getenv(variable);
  if (text) std::this_thread::sleep_for(std::chrono::milliseconds(std::atoi(text)));
}

}  // namespace

extern "C" {

int fsync(int file) {
  wait("SLOW_FLUSH_MS");
  return int(syscall(SYS_fsync, file));
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
  wait("SLOW_RENAME_MS");
  return int(syscall(SYS_renameat2, from_folder, from, to_folder, to, 0));
}
}
