// Selectors of style sheets, as librsvg 2.54 reads them (Selectors Level 3, with lists in :not()).
//
// A list with a selector that librsvg does not know (:is, :has, :hover, pseudo-elements, prefixes of name spaces) is
// invalid, and its rule does nothing. So a drawing looks the same in a collage and alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "artwork/css/css_blocks.h"

namespace tessera {

enum class CssSpace { svg, any, none };  // name spaces

struct CssId {
  std::string id;
};
struct CssClass {
  std::string name;
};
struct CssAttribute {
  enum class Test { exists, equals, has_word, has_language, begins, ends, contains };
  Test test = Test::exists;
  CssSpace space = CssSpace::none;
  bool ignores_case = false;  // applies to ASCII letters of the value
  std::string name;
  std::string value = {};
};
/// :nth-child(an + b) and all selectors that it can express.
struct CssPlace {
  int a = 0;
  int b = 1;
  bool of_type = false;
  bool from_end = false;
};
struct CssLanguages {
  std::vector<std::string> ranges;
};
enum class CssState { root, empty, link, visited };

struct CssSelector;
struct CssNot {
  std::vector<CssSelector> selectors;
};

using CssCondition = std::variant<CssId, CssClass, CssAttribute, CssPlace, CssLanguages, CssState, CssNot>;

/// The conditions on one element.
struct CssCompound {
  CssSpace space = CssSpace::svg;
  std::string type = {};  // empty: any
  std::vector<CssCondition> conditions = {};
};

enum class CssCombinator { descendant, child, next, later };

/// A selector: compounds from left to right, with a combinator between each two.
struct CssSelector {
  std::vector<CssCompound> compounds;
  std::vector<CssCombinator> combinators;
  std::uint32_t specificity = 0;  // the rule with the larger one wins
};

/// The selectors between the commas; nullopt where one of them is not understood.
std::optional<std::vector<CssSelector>> parse_css_selectors(CssTokens tokens);

}  // namespace tessera
