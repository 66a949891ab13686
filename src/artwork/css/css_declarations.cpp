#include "artwork/css/css_declarations.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "artwork/xml/xml_tree.h"

namespace tessera {
namespace {

bool is_known_function(const CssToken& token) {
  static constexpr std::array<std::string_view, 24> kKnown = {
      "rgb",      "rgba",      "hsl",         "hsla",   "matrix",     "translate", "translatex", "translatey",
      "scale",    "scalex",    "scaley",      "rotate", "skewx",      "skewy",     "blur",       "brightness",
      "contrast", "grayscale", "drop-shadow", "invert", "hue-rotate", "opacity",   "saturate",   "sepia"};
  const std::string name = ascii_lower_case(token.text);
  return std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end();
}

/// Whether the mark cannot load anything. A closing bracket is allowed only where one is open.
bool is_harmless(const CssToken& mark) {
  return std::string_view(",/+-*%.!(").find(mark.text) != std::string_view::npos;
}

/// The number of tokens of url("..."), which the tokenizer reads as a function with a string, brackets included; 0
/// where something else is in the brackets.
std::size_t quoted_url_size(CssTokens tokens) {
  std::size_t i = 1;
  while (i < tokens.size() && tokens[i].kind == CssKind::space) ++i;
  if (i == tokens.size() || tokens[i].kind != CssKind::string) return 0;
  ++i;
  while (i < tokens.size() && tokens[i].kind == CssKind::space) ++i;
  return i < tokens.size() && tokens[i].is_mark(')') ? i + 1 : 0;
}

/// Copies a value token by token.
class LocalValue {
 public:
  explicit LocalValue(const std::string& id_prefix) : id_prefix_(id_prefix) {}

  /// The copied text. Nullopt where a token could lead out of the document, or where no text gives these tokens.
  std::optional<std::string> of(CssTokens tokens) {
    while (!tokens.empty()) {
      const std::size_t taken = take(tokens);
      if (taken == 0) return std::nullopt;
      tokens = tokens.subspan(taken);
    }
    copied_.insert(copied_.end(), open_brackets_, CssToken{CssKind::mark, ")"});
    return css_text(copied_);
  }

 private:
  /// Copies tokens and returns how many; 0: the first one is refused.
  std::size_t take(CssTokens tokens) {
    const CssToken& token = tokens.front();
    switch (token.kind) {
      case CssKind::identifier:
      case CssKind::number:
      case CssKind::hash:
      case CssKind::string:
      case CssKind::space: return copy(token), 1;
      case CssKind::url: return copy_url(token.text) ? 1 : 0;
      case CssKind::function: return take_function(tokens);
      case CssKind::mark: return take_mark(token) ? 1 : 0;
      case CssKind::at_keyword:
      case CssKind::comment:
      case CssKind::broken: break;
    }
    return 0;
  }

  std::size_t take_function(CssTokens tokens) {
    if (tokens.front().is_function("url")) {
      const std::size_t size = quoted_url_size(tokens);
      if (size == 0) return 0;
      const auto is_string = [](const CssToken& token) { return token.kind == CssKind::string; };
      return copy_url(std::find_if(tokens.begin(), tokens.end(), is_string)->text) ? size : 0;
    }
    if (!is_known_function(tokens.front())) return 0;
    ++open_brackets_;
    copy(tokens.front());
    return 1;
  }

  bool take_mark(const CssToken& mark) {
    if (mark.is_mark(')')) {
      if (open_brackets_ == 0) return false;
      --open_brackets_;
    } else if (!is_harmless(mark)) {
      return false;
    } else if (mark.is_mark('(')) {
      // A comment separated a name from its bracket: no value has that, and simple readers could see a function.
      if (!copied_.empty() && copied_.back().kind == CssKind::identifier) return false;
      ++open_brackets_;
    }
    copy(mark);
    return true;
  }

  bool copy_url(const std::string& address) {
    if (address.size() < 2 || address.front() != '#') return false;
    const CssToken url{CssKind::url, "#" + id_prefix_ + address.substr(1)};
    if (css_text(std::span(&url, 1)).value_or("\\").find('\\') == std::string::npos) {
      copy(url);
    } else {  // more programs can read quotes than escapes
      copy({CssKind::function, "url"});
      copy({CssKind::string, url.text});
      copy({CssKind::mark, ")"});
    }
    return true;
  }

  void copy(const CssToken& token) { copied_.push_back(token); }

  const std::string& id_prefix_;
  std::vector<CssToken> copied_;
  std::size_t open_brackets_ = 0;
};

/// Whether librsvg knows the name as a property: "FILL" is none.
bool is_property_name(const std::string& name) {
  const auto is_plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !name.empty() && name.front() != '-' && std::all_of(name.begin(), name.end(), is_plain);
}

/// Reads one declaration, from its first token to its semicolon; `text_of` gives the text of the value, or nullopt.
template <class TextOf>
std::optional<CssDeclaration> one_declaration(CssTokens declaration, TextOf text_of) {
  const CssToken& name = declaration.front();
  if (name.kind != CssKind::identifier) return std::nullopt;
  CssTokens rest = trimmed_css(declaration.subspan(1));
  if (rest.empty() || !rest.front().is_mark(':')) return std::nullopt;
  std::optional<std::string> value = text_of(name.text, trimmed_css(rest.subspan(1)));
  if (!value) return std::nullopt;
  return CssDeclaration{name.text, std::move(*value)};
}

/// The end of the declaration or at-rule that begins here. An at-rule may also end with its block.
std::size_t end_of_declaration(CssTokens content) {
  if (content.front().kind != CssKind::at_keyword) return find_css_mark(content, ";");
  const std::size_t end = find_css_mark(content, "{;");
  return end < content.size() && content[end].is_mark('{') ? find_css_mark(content, "}", end + 1) : end;
}

template <class TextOf>
std::vector<CssDeclaration> declarations_of(CssTokens content, TextOf text_of) {
  std::vector<CssDeclaration> declarations;
  while (!content.empty()) {
    if (content.front().kind == CssKind::space || content.front().is_mark(';')) {
      content = content.subspan(1);
      continue;
    }
    const std::size_t end = end_of_declaration(content);
    if (auto declaration = one_declaration(content.first(end), text_of)) declarations.push_back(*declaration);
    content = content.subspan(std::min(end + 1, content.size()));
  }
  return declarations;
}

/// The position of "!important"; npos where there is none.
std::size_t importance(const std::string& value) {
  const std::size_t mark = value.rfind('!');
  if (mark == std::string::npos) return mark;
  std::string_view word = std::string_view(value).substr(mark + 1);
  return ascii_lower_case(take_word(word)) == "important" ? mark : std::string::npos;
}

}  // namespace

std::optional<std::string> local_css_value(std::string_view value, const std::string& id_prefix) {
  if (value.find('(') == std::string_view::npos) return std::string(value);  // no function: refers to nothing
  const std::vector<CssToken> tokens = css_tokens(value);
  return LocalValue(id_prefix).of(trimmed_css(tokens));
}

std::vector<CssDeclaration> local_css_declarations(CssTokens content, const std::string& id_prefix) {
  return declarations_of(content, [&](const std::string& name, CssTokens value) {
    return is_property_name(name) ? LocalValue(id_prefix).of(value) : std::nullopt;
  });
}

std::vector<CssDeclaration> css_declarations(CssTokens content) {
  return declarations_of(content, [](const std::string&, CssTokens value) { return css_text(value); });
}

std::string css_text_of(const std::vector<CssDeclaration>& declarations) {
  std::string text;
  for (const CssDeclaration& declaration : declarations)
    text += (text.empty() ? "" : ";") + declaration.name + ":" + declaration.value;
  return text;
}

bool is_important(const std::string& value) { return importance(value) != std::string::npos; }

std::map<std::string, std::string> counting_values(const std::vector<CssDeclaration>& declarations) {
  std::map<std::string, std::string> values;
  for (const CssDeclaration& declaration : declarations) {
    const auto found = values.find(declaration.name);
    if (found != values.end() && is_important(found->second) && !is_important(declaration.value)) continue;
    values[declaration.name] = declaration.value;
  }
  return values;
}

std::string without_important(std::string value) {
  if (is_important(value)) value.erase(importance(value));
  return value;
}

}  // namespace tessera
