// Opens and reads files that are named by a user or a foreign library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "files/file_descriptor.h"

namespace tessera {

/// Opens a regular file for reading; links are followed. Anything else is refused before it is opened. A pipe would
/// block, a device may never end or may act, and a file that the kernel makes up (proc, sysfs) may do all of that.
/// Throws InputError, which names `path` and its kind, and EnvironmentError where the process may open no more files.
FileDescriptor open_regular_file(const std::string& path);

std::uint64_t size_of(const std::string& path, const FileDescriptor& file);

/// Reads from byte `at` until `bytes` is full or the file ends; returns the number of bytes read. Throws InputError,
/// which names `path`, where the file cannot be read.
std::size_t read_at(const std::string& path, const FileDescriptor& file, std::uint64_t at,
                    std::span<std::uint8_t> bytes);

/// Reads the whole file, with the size that it has when it is opened. Throws InputError where it cannot be read or has
/// more than `most_bytes`.
std::vector<std::uint8_t> read_regular_file(const std::string& path, std::size_t most_bytes);

}  // namespace tessera
