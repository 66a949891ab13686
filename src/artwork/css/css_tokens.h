// The tokens of CSS text, as CSS Syntax Level 3 defines them. Comments give no token, but they divide two tokens.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tessera {

enum class CssKind {
  identifier,
  function,    // its name; the "(" belongs to it
  at_keyword,  // without the "@"
  hash,        // without the "#"
  string,
  url,     // url(...) without quotes
  number,  // with its unit, or a percentage
  space,
  mark,     // one character: punctuation, a bracket, or what nothing else begins with
  comment,  // <!-- or -->
  broken    // a string or url(...) that ends too soon, a number whose unit no program knows
};

struct CssToken {
  CssKind kind = CssKind::mark;
  std::string text = {};  // escapes are replaced; of a mark the character itself
  char quote = '"';       // of a string, the one that the file has
  bool is_name = true;    // of a hash: what follows the "#" is an identifier, so that it can be an id

  bool is_mark(char c) const { return kind == CssKind::mark && text.size() == 1 && text.front() == c; }
  /// Compares names without regard to the case of ASCII letters; `lower` is in lower case.
  bool is_function(std::string_view lower) const;
  bool operator==(const CssToken&) const = default;
};

/// `css` is UTF-8. Never fails: CSS gives a meaning to every text.
std::vector<CssToken> css_tokens(std::string_view css);

/// Text that css_tokens reads as these tokens again. Empty comments divide the tokens where some would join otherwise.
/// Nothing where no text gives these tokens: broken ones and a lone backslash cannot be written.
std::optional<std::string> css_text(std::span<const CssToken> tokens);

std::string ascii_lower_case(std::string_view text);

}  // namespace tessera
