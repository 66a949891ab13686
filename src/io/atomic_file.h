// Files that appear whole or not at all: bytes go to a temporary name in the same folder, are flushed to the disk, and
// are renamed. A reader never sees half a file, a failure leaves none.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tessera::io {

/// Where `path` is written before it is renamed. For writers that open files themselves (HDF5).
std::string temporary_path(const std::string& path);

/// Flushes the finished file at temporary_path(path) to the disk and renames it to `path`, which is replaced.
/// On failure removes the temporary file and throws EnvironmentError with the file's name and the system's reason.
void commit_temporary_file(const std::string& path);

/// Writes `bytes` to temporary_path(path) and flushes them to the disk. Errors as above, `path` is untouched.
void write_temporary_file(const std::string& path, std::span<const std::uint8_t> bytes);

/// Flushes what was renamed in the folder of `path` to the disk. Errors as above.
void flush_folder_of(const std::string& path);

/// Makes `bytes` the content of `path`. Errors as above.
void write_file_atomically(const std::string& path, std::span<const std::uint8_t> bytes);
void write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace tessera::io
