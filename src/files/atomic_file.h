// Files that appear whole or not at all. Their bytes are written under a temporary name in the same folder, flushed to
// the disk, and the file is renamed. A reader never sees half a file, a failure leaves no file, and a finished file
// survives a power cut. Others may write to the folder: whatever they put under the temporary name is removed, and
// never followed or opened.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "files/file_descriptor.h"
#include "files/leftover_file.h"

namespace tessera {

/// The temporary name under which `path` is written.
std::string temporary_path(const std::string& path);

/// A new, empty file under temporary_path(path), for reading and writing; commit() makes it `path`. All members throw
/// EnvironmentError with the file's name and the system's reason. `path` is then unchanged, except where commit() could
/// not flush the folder after renaming.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path);

  /// Takes a file that a library creates by name (HDF5). `create` is called with temporary_path(path). It must create
  /// the file only where nothing has that name (O_EXCL), and return a descriptor of its own; one that is not open where
  /// the name is taken. Exceptions of `create` pass through.
  TemporaryFile(const std::string& path, const std::function<FileDescriptor(const std::string& temporary)>& create);

  /// Removes the file unless it was committed.
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// Another descriptor of the same open file, for a library that closes what it writes to.
  FileDescriptor duplicate() const;

  void write(std::span<const std::uint8_t> bytes);

  /// Waits until the bytes are on the disk.
  void flush();

  /// Flushes the file, renames it to `path` (a file there is replaced), and flushes the folder: bytes and name are on
  /// the disk when this returns. Libraries must have finished writing to the file. Also throws where another program
  /// has put a file of its own under the temporary name.
  void commit();

  /// Closes the file and leaves it under its temporary name for flush_left_files and take_left_files. For files that
  /// must appear together and may be more than can be open at a time. The disk begins to write; the call does not wait.
  void leave();

 private:
  bool is_ours() const;
  void remove() noexcept;
  [[noreturn]] void fail();

  std::string path_;
  std::string name_;  // the temporary name, without the folder
  FileDescriptor folder_;
  std::optional<LeftoverFile> leftover_;
  FileDescriptor file_;
};

/// Waits until the files with these names that TemporaryFile::leave() left in the folder are on the disk. Flushes many
/// files at a time, so that the disk writes them in few passes. Throws EnvironmentError that names the file.
void flush_left_files(const std::string& folder, std::span<const std::string> names);

/// Renames the files with these names that TemporaryFile::leave() left in the folder, in this order (files with the
/// final names are replaced), and flushes the folder. Throws EnvironmentError that names the file or the folder.
void take_left_files(const std::string& folder, std::span<const std::string> names);

/// Makes `bytes` the content of `path`. Throws EnvironmentError as TemporaryFile does.
void write_file_atomically(const std::string& path, std::span<const std::uint8_t> bytes);
void write_file_atomically(const std::string& path, std::string_view bytes);

/// A file without a name on the disk of `path`; it is gone when its last descriptor is closed. For a moment it has the
/// name temporary_path(path) + `suffix`. Throws EnvironmentError that names `path`.
FileDescriptor create_unnamed_file(const std::string& path, const std::string& suffix);

/// Makes `path` a second name (hard link) of `file` in the same folder; a file at `path` is replaced at once. Returns
/// false, with errno, where that is impossible: some file systems have no hard links. Throws EnvironmentError where
/// `path` is a folder.
bool link_atomically(const std::string& file, const std::string& path);

/// Throws EnvironmentError, as write_file_atomically would, where `path` cannot be written. Leaves no file behind, and
/// does not touch a file under the temporary name: another run may be writing it. For commands that compute before they
/// write.
void check_can_be_written(const std::string& path);

}  // namespace tessera
