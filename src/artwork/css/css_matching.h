// Which elements of a parsed SVG a selector selects.
#pragma once

#include <libxml/tree.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "artwork/css/css_selector.h"
#include "artwork/css/sibling_numbers.h"

namespace tessera {

/// Comparisons of selectors with elements that one drawing may need. They take a few seconds at most.
inline constexpr std::uint64_t kMostCssComparisons = 100'000'000;
/// Parts of a selector with a combinator between each two. Matching is recursive: it is as deep as there are parts.
inline constexpr std::size_t kMostCssCompounds = 500;

/// Compares the selectors of one drawing with its elements. The drawing must not change meanwhile.
class CssMatcher {
 public:
  /// `path` names the drawing in messages.
  explicit CssMatcher(const std::string& path) : path_(path) {}

  /// `element` is one of the SVG's own document, all of whose elements count, also those that draw nothing. Elements
  /// without a name space are SVG's, as for librsvg. Throws InputError where all calls together need more than
  /// kMostCssComparisons, or where the selector has more than kMostCssCompounds.
  bool selects(const CssSelector& selector, const xmlNode* element);

 private:
  enum class Match { yes, no, not_among_earlier_siblings, nowhere };

  void count(std::uint64_t comparisons);
  const xmlNode* element_above(const xmlNode* node);
  const xmlNode* element_before(const xmlNode* node);
  const xmlAttr* attribute_of(const xmlNode* node, const CssAttribute& wanted);
  std::string counted(std::string value);
  std::string own_attribute(const xmlNode* node, const char* name);
  std::string language_of(const xmlNode* node);
  bool is_empty(const xmlNode* node);

  bool matches(const CssId& wanted, const xmlNode* node);
  bool matches(const CssClass& wanted, const xmlNode* node);
  bool matches(const CssAttribute& wanted, const xmlNode* node);
  bool matches(const CssPlace& place, const xmlNode* node);
  bool matches(const CssLanguages& languages, const xmlNode* node);
  bool matches(CssState state, const xmlNode* node);
  bool matches(const CssNot& negated, const xmlNode* node);
  bool matches(const CssCompound& compound, const xmlNode* node);
  Match match_up_to(const CssSelector& selector, std::size_t last, const xmlNode* node);

  std::string path_;
  std::uint64_t comparisons_ = 0;
  SiblingNumbers numbers_;
};

}  // namespace tessera
