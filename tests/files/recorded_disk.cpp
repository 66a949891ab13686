#include "recorded_disk.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>

namespace tessera::test {
namespace {

RecordedDisk* recording = nullptr;

std::string name_of(const std::string& path) { return std::filesystem::path(path).filename(); }

std::string flush_step(int file) {
  struct stat status {};
  fstat(file, &status);
  if (S_ISDIR(status.st_mode)) return "flush folder";
  const std::string path = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file));
  return "flush " + name_of(path) + " (" + std::to_string(status.st_size) + " bytes)";
}

void record(const std::string& what, const char* from, const char* to) {
  if (recording) recording->record(what + " " + name_of(from) + " " + name_of(to));
}

}  // namespace

RecordedDisk::RecordedDisk() { recording = this; }
RecordedDisk::~RecordedDisk() { recording = nullptr; }

}  // namespace tessera::test

// These definitions take precedence over those of the C library.
extern "C" {

int fsync(int file) {
  using namespace tessera::test;
  if (recording) {
    recording->record(flush_step(file));
    if (recording->flushes_fail()) {
      errno = ENOSPC;
      return -1;
    }
  }
  return int(syscall(SYS_fsync, file));
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
  tessera::test::record("rename", from, to);
  return int(syscall(SYS_renameat2, from_folder, from, to_folder, to, 0));
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
  tessera::test::record("link", from, to);
  return int(syscall(SYS_linkat, from_folder, from, to_folder, to, flags));
}
}
