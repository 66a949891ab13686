// A JSON file of any size, read as a parser asks for it: for parsers that keep little of what they read.
#pragma once

#include <cstdint>
#include <istream>
#include <streambuf>
#include <string>

#include "files/file_blocks.h"
#include "text/json_bounds.h"

namespace tessera {

/// No text or number of the file may be longer than JsonBounds::token_bytes.
class JsonFile : private std::streambuf {
 public:
  explicit JsonFile(FileBlocks blocks) : blocks_(std::move(blocks)) {}

  /// For nlohmann's parse and sax_parse. What is wrong with the file comes out of them as InputError: with the file's
  /// name where the system cannot read it, without where it has too much.
  std::istream& stream() { return stream_; }
  /// Of the whole file, as Digest::add_all makes it of its bytes. To be asked after it was read.
  std::uint64_t digest() const { return blocks_.digest(); }

 private:
  int_type underflow() override;

  FileBlocks blocks_;
  JsonScan scan_{JsonBounds{}};
  std::string block_;
  std::istream stream_{this};
};

}  // namespace tessera
