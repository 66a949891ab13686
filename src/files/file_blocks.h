// A file that is read block by block, for what may be larger than what should be in memory.
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
  /// Of a file that is open already.
  FileBlocks(FileDescriptor file, const std::string& path, std::size_t most_bytes);

  /// The next bytes, valid until the next call; none at the end. Throws InputError where the file cannot be read or is
  /// shorter than it was.
  std::span<const char> next();

  /// Of the whole file, as Digest::add_all makes it of its bytes. To be asked after the end.
  std::uint64_t digest() const { return digest_.value(); }

 private:
  static constexpr std::size_t kBlockBytes = std::size_t(1) << 18;  // whole words of the digest

  std::string path_;
  FileDescriptor file_;
  std::uint64_t at_bytes_ = 0;
  std::size_t left_bytes_ = 0;
  std::vector<char> block_;
  Digest digest_;
};

}  // namespace tessera
