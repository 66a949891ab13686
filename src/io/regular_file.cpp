#include "io/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/base/error.h"

namespace tessera::io {
namespace {

std::string kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

[[noreturn]] void throw_unreadable(const std::string& path) {
  throw InputError(path + ": not a readable file: " + std::generic_category().message(errno) +
                   ", allowed: a regular file");
}

void check_regular(const struct stat& status, const std::string& path) {
  if (S_ISREG(status.st_mode)) return;
  throw InputError(path + ": not a readable file: found " + kind_of(status.st_mode) + ", allowed: a regular file");
}

std::size_t size_of(const FileDescriptor& file, const std::string& path) {
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) throw_unreadable(path);
  return std::size_t(status.st_size);
}

std::string mebibytes(std::size_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

}  // namespace

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0) ::close(number_);
}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

FileDescriptor open_regular_file(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) throw_unreadable(path);
  check_regular(status, path);
  // Where something else took its place meanwhile, opening it does not block either, and it is not used.
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0) throw_unreadable(path);
  check_regular(status, path);
  return file;
}

std::vector<std::uint8_t> read_regular_file(const std::string& path, std::size_t most_bytes) {
  const FileDescriptor file = open_regular_file(path);
  const std::size_t size = size_of(file, path);
  if (size > most_bytes)
    throw InputError(path + ": " + mebibytes(size) + ", more than the " + mebibytes(most_bytes) + " allowed");
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t done = 0; done < size;) {
    const ssize_t got = ::read(file.number(), bytes.data() + done, size - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw_unreadable(path);
    if (got == 0) throw InputError(path + ": became shorter while it was read");
    done += std::size_t(got);
  }
  return bytes;
}

}  // namespace tessera::io
