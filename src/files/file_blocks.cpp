#include "files/file_blocks.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/base/error.h"

namespace tessera {
namespace {

/// Adds the bytes as words of eight bytes; the last word is filled up with zeros.
void add_words(std::span<const char> bytes, Digest& digest) {
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min(sizeof word, bytes.size() - at));
    digest.add(word);
  }
}

}  // namespace

FileBlocks::FileBlocks(const std::string& path, std::size_t most_bytes)
    : FileBlocks(open_regular_file(path), path, most_bytes) {}

FileBlocks::FileBlocks(FileDescriptor file, const std::string& path, std::size_t most_bytes)
    : path_(path),
      file_(std::move(file)),
      left_bytes_(size_of(path_, file_)) {
  if (left_bytes_ > most_bytes)
    throw InputError(path + ": found " + std::to_string(left_bytes_) +
                     " bytes, allowed: " + std::to_string(most_bytes));
  digest_.add(left_bytes_);
  block_.resize(std::min(kBlockBytes, left_bytes_));
}

std::span<const char> FileBlocks::next() {
  const std::span<char> block(block_.data(), std::min(block_.size(), left_bytes_));
  const std::span bytes(reinterpret_cast<std::uint8_t*>(block.data()), block.size());
  if (read_at(path_, file_, at_bytes_, bytes) < bytes.size())
    throw InputError(path_ + ": became shorter while it was read");
  at_bytes_ += block.size();
  left_bytes_ -= block.size();
  add_words(block, digest_);
  return block;
}

}  // namespace tessera
