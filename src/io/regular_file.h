// Opens and reads files that a user or a foreign library names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tessera::io {

/// An open file that closes itself.
class FileDescriptor {
 public:
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor();
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;

  int number() const { return number_; }

 private:
  int number_;
};

/// Opens a regular file for reading; a link is followed to one. What else may stand under a name is refused before it
/// is opened: a pipe would block, a device may never end or do something. Throws InputError, which names `path` and
/// what it is.
FileDescriptor open_regular_file(const std::string& path);

/// Reads the whole file. Throws InputError where it cannot be read or has more than `most_bytes`.
std::vector<std::uint8_t> read_regular_file(const std::string& path, std::size_t most_bytes);

}  // namespace tessera::io
