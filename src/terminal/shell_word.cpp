#include "terminal/shell_word.h"

#include <cstdio>

#include "text/utf8_text.h"

namespace tessera {
namespace {

bool can_be_printed(const std::string& text) { return printable_utf8(text) == text; }

std::string escaped(const std::string& text) {
  std::string word = "$'";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    const std::string character = text.substr(at, length == 0 ? 1 : length);
    at += character.size();
    if (can_be_printed(character) && character != "'" && character != "\\") {
      word += character;
      continue;
    }
    for (const char byte : character) {
      char octal[8];
      std::snprintf(octal, sizeof octal, "\\%03o", static_cast<unsigned char>(byte));
      word += octal;
    }
  }
  return word + "'";
}

}  // namespace

std::string shell_word(const std::string& text) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+=,:@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  if (!can_be_printed(text)) return escaped(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string shell_cell(const std::string& text) {
  return can_be_printed(text) && !text.starts_with("$'") ? text : escaped(text);
}

}  // namespace tessera
