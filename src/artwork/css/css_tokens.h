// The tokens of CSS text, as CSS Syntax Level 3 defines them. Comments are no tokens, but they separate tokens.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tessera {

enum class CssKind {
  identifier,
  function,    // its name; the "(" is part of it
  at_keyword,  // without the "@"
  hash,        // without the "#"
  string,
  url,     // url(...) without quotes
  number,  // with its unit, or a percentage
  space,
  mark,     // one character: punctuation, a bracket, or one that begins no other token
  comment,  // <!-- or -->
  broken    // a string or url(...) without an end, or a number with a unit that no program knows
};

struct CssToken {
  CssKind kind = CssKind::mark;
  std::string text = {};  // escapes are replaced; for a mark the character itself
  char quote = '"';       // for a string: the quote in the file
  bool is_name = true;    // for a hash: whether an identifier follows the "#", so that it can be an id

  bool is_mark(char c) const { return kind == CssKind::mark && text.size() == 1 && text.front() == c; }
  /// Compares function names, ignoring the case of ASCII letters; `lower` is in lower case.
  bool is_function(std::string_view lower) const;
  bool operator==(const CssToken&) const = default;
};

/// The tokens of `css`, which is UTF-8. Never fails: CSS gives every text a meaning.
std::vector<CssToken> css_tokens(std::string_view css);

/// Text that css_tokens reads as these tokens again. Empty comments separate tokens that would otherwise join. Nullopt
/// where no text gives these tokens: broken tokens and a single backslash cannot be written.
std::optional<std::string> css_text(std::span<const CssToken> tokens);

std::string ascii_lower_case(std::string_view text);

}  // namespace tessera
