#include "io/utf8_text.h"

#include <cstddef>
#include <cstdint>

namespace tessera::io {
namespace {

bool is_continuation(unsigned char c) { return (c & 0xc0) == 0x80; }

/// Length of the valid, printable UTF-8 character at `at`; 0 where there is none.
std::size_t character_bytes(const std::string& text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7f ? 1 : 0;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc2 ? 2 : 0;
  if (length == 0 || at + length > text.size()) return 0;
  std::uint32_t code = lead & (0x7fu >> length);
  for (std::size_t k = 1; k < length; ++k) {
    const auto c = static_cast<unsigned char>(text[at + k]);
    if (!is_continuation(c)) return 0;
    code = code << 6 | (c & 0x3fu);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool c1_control = code >= 0x80 && code < 0xa0;
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return overlong || c1_control || surrogate || code > 0x10ffff ? 0 : length;
}

}  // namespace

std::string printable_utf8(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = character_bytes(text, at);
    if (bytes == 0) {
      result += '_';
      ++at;
    } else {
      result.append(text, at, bytes);
      at += bytes;
    }
  }
  return result;
}

std::string cut_utf8(const std::string& text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return text;
  std::size_t end = most_bytes;
  while (end > 0 && is_continuation(static_cast<unsigned char>(text[end]))) --end;
  return text.substr(0, end);
}

}  // namespace tessera::io
