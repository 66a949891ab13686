// A file that is read block by block, as it may be too large for the memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/digest.h"
#include "files/regular_file.h"

namespace tessera {

class FileBlocks {
 public:
  /// Opens a regular file. Throws InputError where it cannot be read or has more than `most_bytes`.
  FileBlocks(const std::string& path, std::size_t most_bytes);
  /// Reads a file that is already open.
  FileBlocks(FileDescriptor file, const std::string& path, std::size_t most_bytes);

  /// The next bytes, valid until the next call; empty at the end. Throws InputError where the file cannot be read or
  /// has become shorter.
  std::span<const char> next();

  /// The digest of the whole file, equal to Digest::add_all of its bytes. Valid only after the end was read.
  std::uint64_t digest() const { return digest_.value(); }

 private:
  static constexpr std::size_t kBlockBytes = std::size_t(1) << 18;  // a multiple of the digest's words

  std::string path_;
  FileDescriptor file_;
  std::uint64_t at_bytes_ = 0;
  std::size_t left_bytes_ = 0;
  std::vector<char> block_;
  Digest digest_;
};

}  // namespace tessera
