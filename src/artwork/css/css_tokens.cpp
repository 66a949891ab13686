#include "artwork/css/css_tokens.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <utility>

namespace tessera {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hex_digit(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n'; }
bool begins_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}
bool is_name_character(char c) { return begins_name(c) || is_digit(c) || c == '-'; }
bool is_not_printable(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code <= 8 || code == 0x0b || (code >= 0x0e && code <= 0x1f) || code == 0x7f;
}

/// The character in UTF-8. U+FFFE and U+FFFF are replaced, too: XML, which will hold the text, forbids them.
std::string utf8_of(std::uint32_t code) {
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code == 0 || code > 0x10ffff || is_surrogate || (code | 1) == 0xffff) return std::string(kReplacement);
  if (code < 0x80) return {char(code)};
  if (code < 0x800) return {char(0xc0 | code >> 6), char(0x80 | (code & 0x3f))};
  if (code < 0x10000) return {char(0xe0 | code >> 12), char(0x80 | (code >> 6 & 0x3f)), char(0x80 | (code & 0x3f))};
  return {char(0xf0 | code >> 18), char(0x80 | (code >> 12 & 0x3f)), char(0x80 | (code >> 6 & 0x3f)),
          char(0x80 | (code & 0x3f))};
}

/// Whether the unit, written behind a number without escapes, is read as this unit again.
bool is_plain_unit(const std::string& unit) {
  if (!begins_name(unit.front()) || !std::all_of(unit.begin(), unit.end(), is_name_character)) return false;
  if (unit.front() != 'e' && unit.front() != 'E') return true;
  const std::size_t sign = unit.size() > 1 && unit[1] == '-' ? 1 : 0;
  return unit.size() <= 1 + sign || !is_digit(unit[1 + sign]);  // otherwise the unit would be an exponent
}

/// All line ends become "\n", and NUL becomes U+FFFD.
std::string preprocessed(std::string_view css) {
  std::string text;
  text.reserve(css.size());
  for (std::size_t i = 0; i < css.size(); ++i) {
    if (css[i] == '\0') {
      text += kReplacement;
    } else if (css[i] == '\r' || css[i] == '\f') {
      if (css[i] == '\r' && i + 1 < css.size() && css[i + 1] == '\n') continue;
      text += '\n';
    } else {
      text += css[i];
    }
  }
  return text;
}

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view css) : text_(preprocessed(css)) {}

  std::vector<CssToken> tokens() {
    std::vector<CssToken> tokens;
    for (skip_comments(); at_ < text_.size(); skip_comments()) {
      CssToken token = next();
      const bool goes_on = token.kind == CssKind::space && !tokens.empty() && tokens.back().kind == CssKind::space;
      if (!goes_on) tokens.push_back(std::move(token));  // white space on both sides of a comment is one token
    }
    return tokens;
  }

 private:
  /// The next character; NUL behind the end (preprocessing leaves none inside).
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool ended() const { return at_ >= text_.size(); }
  bool looks_at(std::string_view part) const { return std::string_view(text_).substr(at_).starts_with(part); }

  bool escape_begins(std::size_t ahead = 0) const { return peek(ahead) == '\\' && peek(ahead + 1) != '\n'; }
  bool name_begins(std::size_t ahead = 0) const {
    if (peek(ahead) == '-') {
      return begins_name(peek(ahead + 1)) || peek(ahead + 1) == '-' || escape_begins(ahead + 1);
    }
    return begins_name(peek(ahead)) || escape_begins(ahead);
  }
  bool number_begins() const {
    const std::size_t sign = peek() == '+' || peek() == '-' ? 1 : 0;
    return is_digit(peek(sign)) || (peek(sign) == '.' && is_digit(peek(sign + 1)));
  }

  void skip_comments() {
    while (looks_at("/*")) {
      const std::size_t end = text_.find("*/", at_ + 2);
      at_ = end == std::string::npos ? text_.size() : end + 2;
    }
  }

  CssToken next() {
    const char c = peek();
    if (is_space(c)) return space();
    if (c == '"' || c == '\'') return string();
    if (c == '#' && (is_name_character(peek(1)) || escape_begins(1))) return hash();
    if (number_begins()) return number();
    for (const std::string_view comment : {"<!--", "-->"}) {
      if (looks_at(comment)) return skip(comment.size(), {CssKind::comment, std::string(comment)});
    }
    if (c == '@' && name_begins(1)) return skip(1), CssToken{CssKind::at_keyword, name()};
    if (name_begins()) return identifier_like();
    return skip(1, {CssKind::mark, std::string(1, c)});
  }

  void skip(std::size_t count) { at_ += count; }
  CssToken skip(std::size_t count, CssToken token) {
    at_ += count;
    return token;
  }

  CssToken space() {
    while (is_space(peek())) ++at_;
    return {CssKind::space, " "};
  }

  /// Reads an escape; the position is at the backslash.
  std::string escaped() {
    ++at_;
    if (ended()) return std::string(kReplacement);
    if (!is_hex_digit(peek())) return std::string(1, text_[at_++]);
    std::string digits;
    while (digits.size() < 6 && is_hex_digit(peek())) digits += text_[at_++];
    if (is_space(peek())) ++at_;
    return utf8_of(std::uint32_t(std::stoul(digits, nullptr, 16)));
  }

  std::string name() {
    std::string name;
    while (true) {
      if (is_name_character(peek())) {
        name += text_[at_++];
      } else if (escape_begins()) {
        name += escaped();
      } else {
        return name;
      }
    }
  }

  CssToken hash() {
    ++at_;
    const bool is_name = name_begins();
    CssToken token{CssKind::hash, name()};
    token.is_name = is_name;
    return token;
  }

  CssToken string() {
    CssToken token{CssKind::string};
    token.quote = text_[at_++];
    while (!ended()) {
      if (peek() == token.quote) return skip(1, std::move(token));
      if (peek() == '\n') break;
      if (peek() != '\\') {
        token.text += text_[at_++];
      } else if (peek(1) == '\n') {
        at_ += 2;
      } else {
        token.text += escaped();
      }
    }
    token.kind = CssKind::broken;
    return token;
  }

  void digits(std::string& number) {
    while (is_digit(peek())) number += text_[at_++];
  }

  CssToken number() {
    CssToken token{CssKind::number};
    if (peek() == '+' || peek() == '-') token.text += text_[at_++];
    digits(token.text);
    if (peek() == '.' && is_digit(peek(1))) {
      token.text += text_[at_++];
      digits(token.text);
    }
    const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if ((peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign))) {
      token.text.append(text_, at_, 1 + sign);
      at_ += 1 + sign;
      digits(token.text);
    }
    if (peek() == '%') {
      token.text += text_[at_++];
    } else if (name_begins()) {
      const std::string unit = name();
      if (!is_plain_unit(unit)) token.kind = CssKind::broken;
      token.text += unit;
    }
    return token;
  }

  CssToken identifier_like() {
    CssToken token{CssKind::identifier, name()};
    if (peek() != '(') return token;
    ++at_;
    token.kind = CssKind::function;
    if (!token.is_function("url")) return token;
    std::size_t ahead = 0;
    while (is_space(peek(ahead))) ++ahead;
    return peek(ahead) == '"' || peek(ahead) == '\'' ? token : url();
  }

  /// Reads an address without quotes; the position is behind "url(".
  CssToken url() {
    CssToken token{CssKind::url};
    while (is_space(peek())) ++at_;
    while (!ended()) {
      const char c = peek();
      if (c == ')') return skip(1, std::move(token));
      if (is_space(c)) {
        while (is_space(peek())) ++at_;
        if (peek() == ')') return skip(1, std::move(token));
        break;
      }
      if (c == '"' || c == '\'' || c == '(' || is_not_printable(c) || (c == '\\' && !escape_begins())) break;
      token.text += c == '\\' ? escaped() : std::string(1, text_[at_++]);
    }
    skip_broken_url();
    token.kind = CssKind::broken;
    return token;
  }

  void skip_broken_url() {
    while (!ended() && peek() != ')') {
      if (escape_begins()) {
        escaped();
      } else {
        ++at_;
      }
    }
    if (!ended()) ++at_;
  }

  std::string text_;
  std::size_t at_ = 0;
};

std::string escape_of(char c) {
  char text[8];
  std::snprintf(text, sizeof text, "\\%x ", unsigned(static_cast<unsigned char>(c)));
  return text;
}

/// The name as CSSOM serialises an identifier. `goes_on`: it follows a "#", so any of its characters may be first.
std::string name_text(const std::string& name, bool goes_on) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool digit_at_start = is_digit(c) && !goes_on && (i == 0 || (i == 1 && name[0] == '-'));
    const bool lone_hyphen = c == '-' && !goes_on && name.size() == 1;
    if (is_name_character(c) && !digit_at_start && !lone_hyphen) {
      text += c;
    } else {
      text += escape_of(c);
    }
  }
  return text;
}

std::string string_text(const std::string& value, char quote) {
  std::string text(1, quote);
  for (const char c : value) {
    if (c == quote || c == '\\' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      text += escape_of(c);
    } else {
      text += c;
    }
  }
  return text + quote;
}

bool is_plain_in_url(char c) {
  return static_cast<unsigned char>(c) > ' ' && c != 0x7f &&
         std::string_view("\"'()\\").find(c) == std::string_view::npos;
}

/// url(...) without quotes; characters that it cannot hold are escaped.
std::string url_text(const std::string& address) {
  std::string text = "url(";
  for (const char c : address) {
    if (is_plain_in_url(c)) {
      text += c;
    } else {
      text += escape_of(c);
    }
  }
  return text + ")";
}

std::string token_text(const CssToken& token) {
  switch (token.kind) {
    case CssKind::identifier: return name_text(token.text, false);
    case CssKind::function: return name_text(token.text, false) + "(";
    case CssKind::at_keyword: return "@" + name_text(token.text, false);
    case CssKind::hash: return "#" + name_text(token.text, !token.is_name);
    case CssKind::string: return string_text(token.text, token.quote);
    case CssKind::url: return url_text(token.text);
    case CssKind::broken: return "";
    case CssKind::number:
    case CssKind::space:
    case CssKind::mark:
    case CssKind::comment: break;
  }
  return token.text;
}

bool stands_apart(const CssToken& token) {
  return token.kind == CssKind::space || token.is_mark(',') || token.is_mark(')');
}

/// Whether the tokens could join. Nothing joins with a function's bracket; a comment behind "url(" would be an address.
bool could_join(const CssToken& first, const CssToken& second) {
  return first.kind != CssKind::function && !stands_apart(first) && !stands_apart(second);
}

std::string text_of(std::span<const CssToken> tokens, std::string_view between) {
  std::string text;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (i > 0 && could_join(tokens[i - 1], tokens[i])) text += between;
    text += token_text(tokens[i]);
  }
  return text;
}

}  // namespace

bool CssToken::is_function(std::string_view lower) const {
  return kind == CssKind::function && ascii_lower_case(text) == lower;
}

std::vector<CssToken> css_tokens(std::string_view css) { return Tokenizer(css).tokens(); }

std::optional<std::string> css_text(std::span<const CssToken> tokens) {
  for (const std::string_view between : {"", "/**/"}) {
    std::string text = text_of(tokens, between);
    const std::vector<CssToken> again = css_tokens(text);
    if (std::equal(again.begin(), again.end(), tokens.begin(), tokens.end())) return text;
  }
  return std::nullopt;
}

std::string ascii_lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return lower;
}

}  // namespace tessera
