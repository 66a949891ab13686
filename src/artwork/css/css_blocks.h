// Finds the ends of brackets in CSS.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "artwork/css/css_tokens.h"

namespace tessera {

using CssTokens = std::span<const CssToken>;

/// The bracket that closes what this token opens; 0 where it opens nothing.
char css_closer(const CssToken& token);

/// Index, from `from` on, of the first mark of `marks` outside of brackets; tokens.size() where there is none.
std::size_t find_css_mark(CssTokens tokens, std::string_view marks, std::size_t from = 0);

/// The tokens without white space at both ends.
CssTokens trimmed_css(CssTokens tokens);

}  // namespace tessera
