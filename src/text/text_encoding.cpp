#include "text/text_encoding.h"

#include <boost/locale/encoding_utf.hpp>
#include <sstream>
#include <string_view>

#include "core/base/error.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr const char* kSaveAsUtf8 = "; allowed: UTF-8, or UTF-16 with its byte order mark; save the file in UTF-8";
constexpr std::size_t kMostShownBytes = 80;

[[noreturn]] void refuse(const std::string& where, const std::string& found) {
  throw InputError(where + ": found " + found + kSaveAsUtf8);
}

std::string from_utf16(std::string_view bytes, bool high_byte_first, const std::string& shown) {
  if (bytes.size() % 2 != 0) refuse(shown, "UTF-16 that ends within a character");
  std::u16string units;
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    units += char16_t(high_byte_first ? first << 8 | second : second << 8 | first);
  }
  try {
    return boost::locale::conv::utf_to_utf<char>(units, boost::locale::conv::stop);
  } catch (const boost::locale::conv::conversion_error&) {
    refuse(shown, "UTF-16 with half a character");
  }
}

void check_lines(const std::string& text, const std::string& shown) {
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const std::string where = shown + ":" + std::to_string(number);
    if (line.find('\0') != line.npos)
      refuse(where, "a byte of 0, as in UTF-16 without its mark, or in what is no text");
    if (is_utf8(line)) continue;
    refuse(where, "\"" + cut_utf8(printable_utf8(line), kMostShownBytes) +
                      "\", which is not UTF-8 but another encoding, such as Latin-1");
  }
}

}  // namespace

std::string utf8_text(std::span<const std::uint8_t> bytes, const std::string& shown) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\xff\xfe")) return from_utf16(text.substr(2), false, shown);
  if (text.starts_with("\xfe\xff")) return from_utf16(text.substr(2), true, shown);
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  std::string result(text);
  check_lines(result, shown);
  return result;
}

}  // namespace tessera
