// Files that appear whole or not at all: bytes go to a temporary name in the same folder, are flushed to the disk, and
// are renamed. A reader never sees half a file, a failure leaves none, and what was written survives a power cut.
// Others may write to the folder: whatever they put under the temporary name is removed, and never followed or opened.
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

/// The name under which `path` is written before it is renamed.
std::string temporary_path(const std::string& path);

/// A new, empty file under temporary_path(path), for reading and writing, which becomes `path` in the end. All members
/// throw EnvironmentError with the file's name and the system's reason; `path` is untouched then, but where commit()
/// could not flush the folder after it had renamed the file.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path);

  /// For libraries that create files by name (HDF5). `create` is called with temporary_path(path), creates that file
  /// only where there is nothing under the name (O_EXCL), and returns a descriptor of its own, or one that is not open
  /// where the name is taken. What `create` throws is passed on.
  TemporaryFile(const std::string& path, const std::function<FileDescriptor(const std::string& temporary)>& create);

  /// Removes the file unless it was committed.
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// Another descriptor of the same open file, for a library that closes what it writes to.
  FileDescriptor duplicate() const;

  void write(std::span<const std::uint8_t> bytes);

  /// The bytes are on the disk when this returns.
  void flush();

  /// Flushes the file, renames it to `path`, which is replaced, and flushes the folder: both the bytes and the name are
  /// on the disk when this returns. All libraries that write to the file are done with it. Throws also where another
  /// program has put a file of its own under the temporary name.
  void commit();

  /// Leaves the file under its temporary name for flush_left_files and take_left_files, for files that appear together:
  /// they may be more than can be open at a time. The disk begins to write, and nobody waits for it.
  void leave();

 private:
  bool is_ours() const;
  void remove() noexcept;
  [[noreturn]] void fail();

  std::string path_;
  std::string name_;  // the temporary one, without its folder
  FileDescriptor folder_;
  std::optional<LeftoverFile> leftover_;
  FileDescriptor file_;
};

/// The bytes of what TemporaryFile::leave() left of these names in the folder are on the disk when this returns. Many
/// files wait for the disk at a time, so that it writes them in few goes. Throws EnvironmentError that names the file.
void flush_left_files(const std::string& folder, std::span<const std::string> names);

/// Renames what TemporaryFile::leave() left of these names in the folder, in this order, each of which is replaced, and
/// flushes the folder. Throws EnvironmentError that names the file or the folder.
void take_left_files(const std::string& folder, std::span<const std::string> names);

/// Makes `bytes` the content of `path`. Throws EnvironmentError as above.
void write_file_atomically(const std::string& path, std::span<const std::uint8_t> bytes);
void write_file_atomically(const std::string& path, std::string_view bytes);

/// A file without a name on the disk of `path`, which is gone when its last descriptor is closed. For a moment it has
/// the name temporary_path(path) + `suffix`. Throws EnvironmentError that names `path`.
FileDescriptor create_unnamed_file(const std::string& path, const std::string& suffix);

/// Makes `path` a second name (hard link) of `file`, which lies in the same folder; `path` is replaced at once. Returns
/// false with errno where that cannot be: some file systems have no hard links. Throws EnvironmentError where a folder
/// has the name `path`.
bool link_atomically(const std::string& file, const std::string& path);

/// Throws EnvironmentError, as write_file_atomically would, where `path` cannot be written. Leaves nothing behind, and
/// what stands under the temporary name, as another run may be writing there. For commands that compute before they
/// write.
void check_can_be_written(const std::string& path);

}  // namespace tessera
