#include "files/own_file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

#include "core/base/error.h"
#include "files/file_kind.h"
#include "files/named_file.h"

namespace tessera {
namespace {

[[noreturn]] void throw_not_ours(const std::string& path, const std::string& found) {
  throw EnvironmentError("cannot write " + path + ": found " + found +
                         ", allowed: a regular file with this one name; remove it");
}

}  // namespace

FileDescriptor open_own_file(const std::string& path, int flags) {
  constexpr int kAlways = O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  FileDescriptor file(::open(path.c_str(), flags | kAlways, kNewFileMode));
  const int reason = errno;
  struct stat status {};
  const bool known = file.is_open() ? ::fstat(file.number(), &status) == 0 : ::lstat(path.c_str(), &status) == 0;
  if (known && !S_ISREG(status.st_mode)) throw_not_ours(path, file_kind(status.st_mode));
  if (!file.is_open()) throw EnvironmentError("cannot write " + path + ": " + std::generic_category().message(reason));
  if (status.st_nlink > 1) throw_not_ours(path, "a file with a second name (hard link)");
  return file;
}

}  // namespace tessera
