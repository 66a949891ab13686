#include "files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "core/base/error.h"
#include "core/base/task_pool.h"
#include "files/files_read.h"
#include "files/named_file.h"
#include "files/signals_blocked.h"
#include "files/write_all.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

/// Attempts to create a file under a temporary name. The name is taken again between its removal and the creation only
/// where another program does so on purpose.
constexpr int kTries = 5;

std::string message(int reason) { return std::generic_category().message(reason); }

[[noreturn]] void throw_cannot_write(const std::string& path, const std::string& reason) {
  throw EnvironmentError("cannot write " + path + ": " + reason);
}

/// The file name without its folder.
std::string name_of(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  if (name.empty()) throw_cannot_write(path, message(EISDIR));
  return name;
}

std::string temporary_name_of(const std::string& path) { return temporary_path(name_of(path)); }

/// The status of what has the name; all 0 where nothing has it.
struct stat status_of(const FileDescriptor& folder, const std::string& name) {
  struct stat named {};
  if (::fstatat(folder.number(), name.c_str(), &named, AT_SYMLINK_NOFOLLOW) != 0) named = {};
  return named;
}

FileDescriptor open_folder(const std::string& folder, const std::string& path) {
  FileDescriptor open(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!open.is_open()) throw_cannot_write(path, message(errno));
  return open;
}

/// Flushes the folder; otherwise a power cut may undo a renaming. Some file systems cannot flush a folder (EINVAL) and
/// keep the order themselves. False, with errno, on failure.
bool flush_folder(const FileDescriptor& folder) { return ::fsync(folder.number()) == 0 || errno == EINVAL; }

/// Opens the folder of a file that will become `path`. Refuses a `path` that is, for example, a device: renaming would
/// replace whatever has that name, and a user who names /dev/null does not want that.
FileDescriptor open_folder_of(const std::string& path) {
  FileDescriptor folder = open_folder(fs::path(path).parent_path(), path);
  const mode_t mode = status_of(folder, name_of(path)).st_mode;
  if (S_ISDIR(mode)) throw_cannot_write(path, message(EISDIR));
  if (S_ISCHR(mode) || S_ISBLK(mode)) throw_cannot_write(path, "it is a device");
  return folder;
}

/// Creates a new file. Not open, with errno, where that is impossible, e.g. because the name is taken.
FileDescriptor create(const FileDescriptor& folder, const std::string& name) {
  constexpr int kNew = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  return FileDescriptor(::openat(folder.number(), name.c_str(), kNew, kNewFileMode));
}

[[noreturn]] void throw_in_the_way(const std::string& path, const std::string& name, int reason) {
  throw_cannot_write(path, name + " is in the way and cannot be removed: " + message(reason));
}

[[noreturn]] void throw_replaced(const std::string& path, const std::string& name) {
  throw_cannot_write(path, "another program put a file of its own under the name " + name);
}

void check_is_not_read(const std::string& path, const FileDescriptor& folder, const std::string& name) {
  if (was_read(status_of(folder, name)))
    throw_cannot_write(path, name + " would be removed, and is read here; give another name");
}

/// Removes what has the name, then returns the file that `create` creates there; it will become `path`. Where another
/// program was faster, `create` returns a file that is not open, and is called again.
FileDescriptor create_anew(const std::string& path, const FileDescriptor& folder, const std::string& name,
                           const std::function<FileDescriptor()>& create) {
  for (int i = 0; i < kTries; ++i) {
    check_is_not_read(path, folder, name);
    if (::unlinkat(folder.number(), name.c_str(), 0) != 0 && errno != ENOENT) throw_in_the_way(path, name, errno);
    if (FileDescriptor file = create(); file.is_open()) return file;
  }
  throw_cannot_write(path, "another program keeps making " + name);
}

FileDescriptor create_anew(const std::string& path, const FileDescriptor& folder, const std::string& name) {
  return create_anew(path, folder, name, [&] {
    FileDescriptor file = create(folder, name);
    if (!file.is_open() && errno != EEXIST) throw_cannot_write(path, message(errno));
    return file;
  });
}

}  // namespace

std::string temporary_path(const std::string& path) { return path + ".tmp"; }

TemporaryFile::TemporaryFile(const std::string& path)
    : path_(path),
      name_(temporary_name_of(path)),
      folder_(open_folder_of(path)),
      leftover_(std::in_place, temporary_path(path)),
      file_(create_anew(path, folder_, name_)) {}

TemporaryFile::TemporaryFile(const std::string& path, const std::function<FileDescriptor(const std::string&)>& create)
    : path_(path),
      name_(temporary_name_of(path)),
      folder_(open_folder_of(path)),
      leftover_(std::in_place, temporary_path(path)),
      file_(create_anew(path, folder_, name_, [&] { return create(temporary_path(path)); })) {
  if (!is_ours()) throw_cannot_write(path, "its folder was replaced by another one meanwhile");
}

TemporaryFile::~TemporaryFile() { remove(); }

FileDescriptor TemporaryFile::duplicate() const {
  FileDescriptor other(::fcntl(file_.number(), F_DUPFD_CLOEXEC, 0));
  if (!other.is_open()) throw_cannot_write(path_, message(errno));
  return other;
}

void TemporaryFile::write(std::span<const std::uint8_t> bytes) {
  if (!write_all(file_.number(), bytes)) fail();
}

void TemporaryFile::flush() {
  if (::fsync(file_.number()) != 0) fail();
}

void TemporaryFile::commit() {
  flush();
  if (!is_ours()) throw_replaced(path_, name_);
  const FileDescriptor open = duplicate();
  if (!file_.close()) fail();
  const std::string name = name_of(path_);
  if (::renameat(folder_.number(), name_.c_str(), folder_.number(), name.c_str()) != 0) fail();
  if (!leads_to(folder_.number(), name, open)) throw_replaced(path_, name_);  // replaced at the last moment
  name_.clear();
  leftover_.reset();
  if (!flush_folder(folder_)) fail();
}

void TemporaryFile::leave() {
  // This is only a hint. On ext4 it also allocates the file's blocks, so that the first flush of many files commits
  // all.
  ::sync_file_range(file_.number(), 0, 0, SYNC_FILE_RANGE_WRITE);
  if (!file_.close()) fail();
  name_.clear();
}

bool TemporaryFile::is_ours() const { return leads_to(folder_.number(), name_, file_); }

void TemporaryFile::remove() noexcept {
  if (name_.empty()) return;
  if (!file_.is_open() || is_ours()) ::unlinkat(folder_.number(), name_.c_str(), 0);
  name_.clear();
}

void TemporaryFile::fail() {
  const int reason = errno;
  remove();
  throw_cannot_write(path_, message(reason));
}

void flush_left_files(const std::string& folder, std::span<const std::string> names) {
  TaskPool waiting(32);  // its threads wait for the disk and do not compute: there may be more than the rank's cores
  const FileDescriptor open = open_folder(folder, folder);
  waiting.run(names.size(), [&](std::size_t i) {
    const std::string name = temporary_path(names[i]);
    const FileDescriptor file(::openat(open.number(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (!file.is_open() || ::fsync(file.number()) != 0)
      throw_cannot_write((fs::path(folder) / names[i]).string(), message(errno));
  });
}

void take_left_files(const std::string& folder, std::span<const std::string> names) {
  if (names.empty()) return;
  const FileDescriptor open = open_folder(folder, folder);
  for (const std::string& name : names) {
    if (::renameat(open.number(), temporary_path(name).c_str(), open.number(), name.c_str()) != 0)
      throw_cannot_write((fs::path(folder) / name).string(), message(errno));
  }
  if (!flush_folder(open)) throw_cannot_write(folder, message(errno));
}

void write_file_atomically(const std::string& path, std::span<const std::uint8_t> bytes) {
  TemporaryFile file(path);
  file.write(bytes);
  file.commit();
}

void write_file_atomically(const std::string& path, std::string_view bytes) {
  write_file_atomically(path, bytes_of(bytes));
}

FileDescriptor create_unnamed_file(const std::string& path, const std::string& suffix) {
  const FileDescriptor folder = open_folder_of(path);
  const std::string name = temporary_name_of(path) + suffix;
  FileDescriptor file = create_anew(path, folder, name);
  ::unlinkat(folder.number(), name.c_str(), 0);
  return file;
}

bool link_atomically(const std::string& file, const std::string& path) {
  const FileDescriptor folder = open_folder_of(path);
  const std::string from = name_of(file), temporary = temporary_name_of(path);
  const auto remove_temporary = [&] { ::unlinkat(folder.number(), temporary.c_str(), 0); };
  int result = -1;
  for (int i = 0; i < kTries && result != 0; ++i) {
    remove_temporary();
    result = ::linkat(folder.number(), from.c_str(), folder.number(), temporary.c_str(), 0);
    if (result != 0 && errno != EEXIST) return false;
  }
  if (result != 0) return false;
  result = ::renameat(folder.number(), temporary.c_str(), folder.number(), name_of(path).c_str());
  const int reason = errno;
  remove_temporary();  // it still exists where both were already names of one file
  errno = reason;
  return result == 0;
}

void check_can_be_written(const std::string& path) {
  const FileDescriptor folder = open_folder_of(path);
  const std::string name = temporary_name_of(path);
  if (S_ISDIR(status_of(folder, name).st_mode)) throw_in_the_way(path, name, EISDIR);
  check_is_not_read(path, folder, name);
  const SignalsBlocked blocked;  // no signal may come between the creation of the probe and its note as a leftover
  const FileDescriptor probe = create(folder, name);
  if (!probe.is_open() && errno != EEXIST) throw_cannot_write(path, message(errno));
  if (!probe.is_open()) return;
  const LeftoverFile leftover(temporary_path(path));  // for a signal to another thread
  if (leads_to(folder.number(), name, probe)) ::unlinkat(folder.number(), name.c_str(), 0);
}

}  // namespace tessera
