#include "text/json_file.h"

namespace tessera {

JsonFile::int_type JsonFile::underflow() {
  const std::span<const char> block = blocks_.next();
  scan_.take(block);
  block_.assign(block.begin(), block.end());
  setg(block_.data(), block_.data(), block_.data() + block_.size());
  return block_.empty() ? traits_type::eof() : traits_type::to_int_type(block_.front());
}

}  // namespace tessera
