#include "io/utf8_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace tessera::io {
namespace {

bool is_continuation(unsigned char c) { return (c & 0xc0) == 0x80; }

/// What no line of text has; the last two may not stand in XML.
bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0xfffe || code == 0xffff;
}

/// Unicode's line and paragraph separators, and what embeds, overrides or isolates a direction of writing: a name with
/// one of these changes how the text beside it is shown.
bool is_layout(std::uint32_t code) { return (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069); }

struct Character {
  std::size_t bytes;  // 0: this is none
  std::uint32_t code;
};

/// The character that begins there.
Character character_at(const std::string& text, std::size_t at) {
  constexpr Character kNone{0, 0};
  const auto lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x80) return {1, lead};
  const std::size_t length = lead >= 0xf5 ? 0 : lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc2 ? 2 : 0;
  if (length == 0 || at + length > text.size()) return kNone;
  std::uint32_t code = lead & (0x7fu >> length);
  for (std::size_t k = 1; k < length; ++k) {
    const auto c = static_cast<unsigned char>(text[at + k]);
    if (!is_continuation(c)) return kNone;
    code = code << 6 | (c & 0x3fu);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return overlong || surrogate || code > 0x10ffff ? kNone : Character{length, code};
}

}  // namespace

std::string printable_utf8(const std::string& text, std::string_view kept) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto [bytes, code] = character_at(text, at);
    const bool is_kept = kept.find(text[at]) != kept.npos;
    if (!is_kept && (bytes == 0 || is_control(code) || is_layout(code))) {
      // Of a control character each byte, as of what is no UTF-8.
      result.append(std::max<std::size_t>(1, bytes), '_');
    } else {
      result.append(text, at, bytes);
    }
    at += std::max<std::size_t>(1, bytes);
  }
  return result;
}

bool is_utf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = character_at(text, at).bytes;
    if (bytes == 0) return false;
    at += bytes;
  }
  return true;
}

std::string cut_utf8(const std::string& text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return text;
  std::size_t end = most_bytes;
  while (end > 0 && is_continuation(static_cast<unsigned char>(text[end]))) --end;
  return text.substr(0, end);
}

}  // namespace tessera::io
