// Opens and reads files that a user or a foreign library names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "files/file_descriptor.h"

namespace tessera {

/// Opens a regular file for reading; a link is followed to one. What else may stand under a name is refused before it
/// is opened: a pipe would block, a device may never end or do something, and a file that the kernel makes up (proc,
/// sysfs) may do all of that. Throws InputError, which names `path` and what it is, and
/// EnvironmentError where the process may open no more files.
FileDescriptor open_regular_file(const std::string& path);

std::uint64_t size_of(const std::string& path, const FileDescriptor& file);

/// Reads from byte `at` of the file on, until `bytes` are full or the file ends; returns how many were read. Throws
/// InputError, which names `path`, where it cannot be read.
std::size_t read_at(const std::string& path, const FileDescriptor& file, std::uint64_t at,
                    std::span<std::uint8_t> bytes);

/// Reads the whole file, as long as it is when it is opened. Throws InputError where it cannot be read or has more than
/// `most_bytes`.
std::vector<std::uint8_t> read_regular_file(const std::string& path, std::size_t most_bytes);

}  // namespace tessera
