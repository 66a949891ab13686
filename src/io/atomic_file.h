// Files that appear whole or not at all: bytes go to a temporary name in the same folder, are flushed to the disk, and
// are renamed. A reader never sees half a file, a failure leaves none, and what was written survives a power cut.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tessera::io {

/// The name under which `path` is written before it is renamed, for writers that open files themselves (HDF5).
std::string temporary_path(const std::string& path);

/// Flushes the finished file at temporary_path(path) to the disk, renames it to `path`, which is replaced, and flushes
/// the folder: both the bytes and the name are on the disk when this returns.
/// On failure removes the temporary file and throws EnvironmentError with the file's name and the system's reason.
void commit_temporary_file(const std::string& path);

/// Writes `bytes` to temporary_path(path) and flushes them to the disk. Errors as above, `path` is untouched.
void write_temporary_file(const std::string& path, std::span<const std::uint8_t> bytes);

/// Makes `bytes` the content of `path`. Errors as above.
void write_file_atomically(const std::string& path, std::span<const std::uint8_t> bytes);
void write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace tessera::io
