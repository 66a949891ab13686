#include "files/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/base/error.h"
#include "files/file_kind.h"
#include "files/files_read.h"

namespace tessera {
namespace {

/// Throws InputError for the file, or EnvironmentError where this process has reached a limit of its own.
[[noreturn]] void throw_unreadable(const std::string& path) {
  const int reason = errno;
  const std::string message = std::generic_category().message(reason);
  if (reason == EMFILE || reason == ENFILE || reason == ENOMEM)
    throw EnvironmentError("cannot read " + path + ": " + message);
  throw InputError(path + ": not a readable file: " + message + ", allowed: a file that is there and may be read");
}

[[noreturn]] void throw_found(const std::string& path, const std::string& found) {
  throw InputError(path + ": not a readable file: found " + found + ", allowed: a regular file");
}

void check_regular(const std::string& path, const struct stat& status, const struct statfs& system) {
  if (!S_ISREG(status.st_mode)) throw_found(path, file_kind(status.st_mode));
  const std::string kernel = kernel_file_system(system.f_type);
  if (!kernel.empty()) throw_found(path, "a file of the kernel (" + kernel + ")");
}

/// The message, in the largest unit of which the limit is a whole number. The size found is rounded up, so that it
/// never equals the limit.
std::string more_than_allowed(std::size_t found_bytes, std::size_t most_bytes) {
  constexpr std::size_t kKibibyte = 1 << 10, kMebibyte = 1 << 20;
  const std::size_t unit = most_bytes % kMebibyte == 0 ? kMebibyte : most_bytes % kKibibyte == 0 ? kKibibyte : 1;
  const std::string name = unit == kMebibyte ? " MiB" : unit == kKibibyte ? " KiB" : " bytes";
  return std::to_string((found_bytes + unit - 1) / unit) + name + ", more than the " +
         std::to_string(most_bytes / unit) + name + " allowed";
}

}  // namespace

FileDescriptor open_regular_file(const std::string& path) {
  struct stat status {};
  struct statfs system {};
  if (::stat(path.c_str(), &status) != 0 || ::statfs(path.c_str(), &system) != 0) throw_unreadable(path);
  check_regular(path, status, system);
  // Opening does not block even if something else took the file's place meanwhile; the check below refuses that.
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (!file.is_open() || ::fstat(file.number(), &status) != 0 || ::fstatfs(file.number(), &system) != 0)
    throw_unreadable(path);
  check_regular(path, status, system);
  note_as_read(status);
  return file;
}

std::uint64_t size_of(const std::string& path, const FileDescriptor& file) {
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) throw_unreadable(path);
  return std::uint64_t(status.st_size);
}

std::size_t read_at(const std::string& path, const FileDescriptor& file, std::uint64_t at,
                    std::span<std::uint8_t> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::pread(file.number(), bytes.data() + done, bytes.size() - done, off_t(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw_unreadable(path);
    if (got == 0) break;
    done += std::size_t(got);
  }
  return done;
}

std::vector<std::uint8_t> read_regular_file(const std::string& path, std::size_t most_bytes) {
  const FileDescriptor file = open_regular_file(path);
  const std::size_t size = size_of(path, file);
  if (size > most_bytes) throw InputError(path + ": " + more_than_allowed(size, most_bytes));
  std::vector<std::uint8_t> bytes(size);
  if (read_at(path, file, 0, bytes) < size) throw InputError(path + ": became shorter while it was read");
  return bytes;
}

}  // namespace tessera
