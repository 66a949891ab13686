#include "io/file_blocks.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/base/error.h"

namespace tessera::io {
namespace {

[[noreturn]] void throw_unreadable(const std::string& path) {
  throw InputError(path + ": cannot be read: " + std::generic_category().message(errno));
}

/// In words of eight bytes; the last one is filled up with zeros.
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
      file_(std::move(file)) {
  struct stat status {};
  if (::fstat(file_.number(), &status) != 0) throw_unreadable(path_);
  left_bytes_ = std::size_t(status.st_size);
  if (left_bytes_ > most_bytes)
    throw InputError(path + ": found " + std::to_string(left_bytes_) +
                     " bytes, allowed: " + std::to_string(most_bytes));
  digest_.add(left_bytes_);
  block_.resize(std::min(kBlockBytes, left_bytes_));
}

std::span<const char> FileBlocks::next() {
  const std::span<char> block(block_.data(), std::min(block_.size(), left_bytes_));
  read(block);
  left_bytes_ -= block.size();
  add_words(block, digest_);
  return block;
}

void FileBlocks::read(std::span<char> block) {
  while (!block.empty()) {
    const ssize_t got = ::read(file_.number(), block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw_unreadable(path_);
    if (got == 0) throw InputError(path_ + ": became shorter while it was read");
    block = block.subspan(std::size_t(got));
  }
}

}  // namespace tessera::io
