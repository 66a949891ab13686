#include "artwork/css/css_blocks.h"

#include <vector>

namespace tessera {
namespace {

bool is_one_of(const CssToken& token, std::string_view marks) {
  return token.kind == CssKind::mark && marks.find(token.text) != std::string_view::npos;
}

}  // namespace

char css_closer(const CssToken& token) {
  if (token.kind == CssKind::function || token.is_mark('(')) return ')';
  if (token.is_mark('[')) return ']';
  return token.is_mark('{') ? '}' : '\0';
}

std::size_t find_css_mark(CssTokens tokens, std::string_view marks, std::size_t from) {
  std::vector<char> closers;
  for (std::size_t i = from; i < tokens.size(); ++i) {
    if (closers.empty() && is_one_of(tokens[i], marks)) return i;
    if (!closers.empty() && tokens[i].is_mark(closers.back())) {
      closers.pop_back();
    } else if (const char closer = css_closer(tokens[i])) {
      closers.push_back(closer);
    }
  }
  return tokens.size();
}

CssTokens trimmed_css(CssTokens tokens) {
  while (!tokens.empty() && tokens.front().kind == CssKind::space) tokens = tokens.subspan(1);
  while (!tokens.empty() && tokens.back().kind == CssKind::space) tokens = tokens.first(tokens.size() - 1);
  return tokens;
}

}  // namespace tessera
