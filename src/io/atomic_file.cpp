#include "io/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "io/leftover_file.h"

namespace tessera::io {
namespace {

class Descriptor {
 public:
  Descriptor(const std::string& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool open() const { return fd_ >= 0; }
  int get() const { return fd_; }
  /// Network file systems report a full disk as late as here.
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

bool write_all(int fd, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(std::size_t(written));
  }
  return true;
}

[[noreturn]] void fail(const std::string& path) {
  const int reason = errno;
  std::remove(temporary_path(path).c_str());
  throw EnvironmentError("cannot write " + path + ": " + std::generic_category().message(reason));
}

/// Without it a power cut may undo what was renamed in the folder of `path`.
void flush_folder_of(const std::string& path) {
  const std::string folder = std::filesystem::absolute(path).parent_path();
  Descriptor file(folder, O_RDONLY | O_DIRECTORY);
  // Some file systems cannot flush a folder (EINVAL) and keep its order by themselves.
  if (!file.open() || (::fsync(file.get()) != 0 && errno != EINVAL)) fail(path);
}

}  // namespace

std::string temporary_path(const std::string& path) { return path + ".tmp"; }

void commit_temporary_file(const std::string& path) {
  const LeftoverFile leftover(temporary_path(path));
  Descriptor file(temporary_path(path), O_RDONLY);
  if (!file.open() || ::fsync(file.get()) != 0 || !file.close()) fail(path);
  if (std::rename(temporary_path(path).c_str(), path.c_str()) != 0) fail(path);
  flush_folder_of(path);
}

void write_temporary_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  const LeftoverFile leftover(temporary_path(path));
  Descriptor file(temporary_path(path), O_WRONLY | O_CREAT | O_TRUNC);
  if (!file.open() || !write_all(file.get(), bytes) || ::fsync(file.get()) != 0 || !file.close()) fail(path);
}

void write_file_atomically(const std::string& path, std::span<const std::uint8_t> bytes) {
  const LeftoverFile leftover(temporary_path(path));
  Descriptor file(temporary_path(path), O_WRONLY | O_CREAT | O_TRUNC);
  if (!file.open() || !write_all(file.get(), bytes) || !file.close()) fail(path);
  commit_temporary_file(path);
}

void write_file_atomically(const std::string& path, std::string_view bytes) {
  write_file_atomically(path, std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
}

}  // namespace tessera::io
