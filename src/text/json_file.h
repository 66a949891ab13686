// A JSON file of any size that is read while a parser asks for it: for parsers that keep little of what they read.
#pragma once

#include <cstdint>
#include <istream>
#include <streambuf>
#include <string>

#include "files/file_blocks.h"
#include "text/json_bounds.h"

namespace tessera {

/// The file as a stream. A text or number of it that is longer than JsonBounds::token_bytes is an error.
class JsonFile : private std::streambuf {
 public:
  explicit JsonFile(FileBlocks blocks) : blocks_(std::move(blocks)) {}

  /// The stream for nlohmann's parse and sax_parse. Errors leave the parser as InputError: with the file's name where
  /// the system cannot read the file, without the name where a limit is exceeded.
  std::istream& stream() { return stream_; }
  /// The digest of the whole file, equal to Digest::add_all of its bytes. Valid only after the file was read.
  std::uint64_t digest() const { return blocks_.digest(); }

 private:
  int_type underflow() override;

  FileBlocks blocks_;
  JsonScan scan_{JsonBounds{}};
  std::string block_;
  std::istream stream_{this};
};

}  // namespace tessera
