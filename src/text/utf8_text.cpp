#include "text/utf8_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace tessera {
namespace {

bool is_continuation(unsigned char c) { return (c & 0xc0) == 0x80; }

struct Range {
  std::uint32_t first;
  std::uint32_t last;
};

/// Ranges of invisible characters, ascending: Unicode's control and format characters (categories Cc and Cf), its line
/// and paragraph separators, and others that are not seen (Default_Ignorable_Code_Point). Variation selectors are left
/// out: they only choose between two forms of a character. The characters that change the direction of writing are
/// among the ranges.
constexpr Range kUnseen[] = {
    {0x00, 0x1f},       {0x7f, 0x9f},       {0xad, 0xad},       {0x34f, 0x34f},     {0x600, 0x605},
    {0x61c, 0x61c},     {0x6dd, 0x6dd},     {0x70f, 0x70f},     {0x890, 0x891},     {0x8e2, 0x8e2},
    {0x115f, 0x1160},   {0x17b4, 0x17b5},   {0x180b, 0x180f},   {0x200b, 0x200f},   {0x2028, 0x202e},
    {0x2060, 0x206f},   {0x3164, 0x3164},   {0xfdd0, 0xfdef},   {0xfeff, 0xfeff},   {0xffa0, 0xffa0},
    {0xfff0, 0xfffb},   {0x110bd, 0x110bd}, {0x110cd, 0x110cd}, {0x13430, 0x1343f}, {0x1bca0, 0x1bca3},
    {0x1d173, 0x1d17a}, {0xe0000, 0xe0fff},
};

/// Whether the code is a Unicode noncharacter: the last two codes of every plane. Those of the first plane may not
/// stand in XML.
bool is_no_character(std::uint32_t code) { return (code & 0xfffe) == 0xfffe; }

bool is_unseen(std::uint32_t code) {
  const auto range = std::ranges::lower_bound(kUnseen, code, {}, &Range::last);
  return (range != std::end(kUnseen) && range->first <= code) || is_no_character(code);
}

struct Character {
  std::size_t bytes;  // 0: no valid character
  std::uint32_t code;
};

/// The character that begins at `at`.
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
    if (!is_kept && (bytes == 0 || is_unseen(code))) {
      // One '_' for each byte of the character, as for bytes that are not UTF-8.
      result.append(std::max<std::size_t>(1, bytes), '_');
    } else {
      result.append(text, at, bytes);
    }
    at += std::max<std::size_t>(1, bytes);
  }
  return result;
}

std::size_t utf8_length(const std::string& text, std::size_t at) { return character_at(text, at).bytes; }

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

}  // namespace tessera
