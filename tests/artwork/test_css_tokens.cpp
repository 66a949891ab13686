// CSS text written from tokens has the meaning of the text that was read, whatever comments were in it.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <algorithm>

#include "artwork/css/css_declarations.h"
#include "artwork/css/css_tokens.h"

namespace tessera {
namespace test_css_tokens {

// clang-format off
const std::vector<std::string> kParts = {
    "/*", "*/", "/**/", "/", "*", "//", "'", "\"", "\\", "\\72 ", "\\7e", "\\0", "\\\n", "\\28 ", "\\22 ", "\\2f\\2a ", "\\fffe ",
    "\\d ", "\\c ", "\n", " ", "\t", "(", ")", "[", "]", "{", "}", "url", "url(", "url('", "URL(\"#a\")", "u\\72l(", "url(#a", "rgb(",
    "image-set(", "#", "#a", "#1", "@", "@a", "-", "--", "+", ".", "1", "5%", "e3", "e-3", "E", "px", "1\\65 3", "1\\2d x", "<", "!",
    "<!--", "-->", "a", "_", "red", ":", ";", ",", "~", "|", "=", "$", "^", "&", "\x7f", "\xc3\xa4", "http://x/y.svg#z"};
// clang-format on

rc::Gen<std::string> css_of_parts() {
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(kParts)),
                      [](const std::vector<std::string>& parts) {
                        std::string css;
                        for (const std::string& part : parts) css += part;
                        return css;
                      });
}

bool can_be_written(const CssToken& token) { return token.kind != CssKind::broken && !token.is_mark('\\'); }

RC_GTEST_PROP(CssTokens, WrittenTextGivesTheTokensThatWereRead, ()) {
  const std::vector<CssToken> tokens = css_tokens(*css_of_parts());
  const std::optional<std::string> text = css_text(tokens);
  RC_ASSERT(text.has_value() == std::all_of(tokens.begin(), tokens.end(), can_be_written));
  if (text) RC_ASSERT(css_tokens(*text) == tokens);
}

/// Addresses are compared by meaning, as a copy may write them with or without quotes.
std::vector<CssToken> plain_tokens(const std::vector<CssToken>& tokens) {
  std::vector<CssToken> plain;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!tokens[i].is_function("url")) {
      plain.push_back(tokens[i]);
      continue;
    }
    while (i < tokens.size() && tokens[i].kind != CssKind::string) ++i;
    if (i < tokens.size()) plain.push_back({CssKind::url, tokens[i].text});
    while (i < tokens.size() && !tokens[i].is_mark(')')) ++i;
  }
  return plain;
}

bool refers_elsewhere(const CssToken& token) {
  return (token.kind == CssKind::url && !token.text.starts_with("#p-")) || token.is_function("image-set") ||
         token.is_function("url");
}

/// Covers style attributes and rules of a sheet.
RC_GTEST_PROP(CssTokens, DeclarationsSayWhatTheirFileSays, ()) {
  const std::string css = "fill:" + *css_of_parts();
  std::string style;
  for (const CssDeclaration& declaration : local_css_declarations(css_tokens(css), "p-")) {
    style += declaration.name + ":" + declaration.value + ";";
  }
  const std::vector<CssToken> copied = plain_tokens(css_tokens(style));
  RC_ASSERT(std::none_of(copied.begin(), copied.end(), refers_elsewhere));
  const std::vector<CssToken> read = css_tokens(css);
  const auto strings = [](const std::vector<CssToken>& tokens) {
    return std::count_if(tokens.begin(), tokens.end(), [](const auto& token) { return token.kind == CssKind::string; });
  };
  RC_ASSERT(strings(copied) <= strings(read));
}

RC_GTEST_PROP(CssTokens, PresentationAttributesSayWhatTheirFileSays, ()) {
  const std::string css = *css_of_parts() + "(";
  const std::optional<std::string> value = local_css_value(css, "p-");
  if (!value) return;
  const std::vector<CssToken> copied = plain_tokens(css_tokens(*value));
  RC_ASSERT(std::none_of(copied.begin(), copied.end(), refers_elsewhere));
}

TEST(CssTokens, CommentsDivideTokensThatWouldJoin) {
  for (const char* css : {"url/**/(", "red//**/*", "1/**/2", "1/**/px", "-/**/-", "#/**/a", "@/**/a", "./**/5",
                          "5/**/%", "</**/!--a", "a/**/b", "1/**/e3", "/**/a/**/ /**/b"}) {
    const std::vector<CssToken> tokens = css_tokens(css);
    EXPECT_EQ(css_tokens(css_text(tokens).value_or("")), tokens) << css;
  }
  EXPECT_EQ(css_text(css_tokens("rgb(1,2)/**/url(#a) /* x */ b")), "rgb(1,2)url(#a) b");
  EXPECT_EQ(css_text(css_tokens("5/**/3")), "5/**/3");
}

/// When a number and its unit are joined, another number could result.
TEST(CssTokens, NumbersStayTheNumbersThatTheyWere) {
  for (const char* css : {"1\\65 3", "1\\65-3", "1\\35 ", "1\\2d 5"}) {
    EXPECT_EQ(css_tokens(css).front().kind, CssKind::broken) << css;
  }
  for (const char* css : {"1em", "1e3", "1e3px", "2n-1", "1ex", "1e-x"}) {
    EXPECT_EQ(css_tokens(css).size(), 1u) << css;
    EXPECT_EQ(css_text(css_tokens(css)), css);
  }
}

}  // namespace test_css_tokens
}  // namespace tessera
