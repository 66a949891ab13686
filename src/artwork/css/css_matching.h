// Decides which elements of a parsed SVG a selector selects.
#pragma once

#include <libxml/tree.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "artwork/css/css_selector.h"
#include "artwork/css/sibling_numbers.h"

namespace tessera {

/// Most comparisons of selectors with elements for one drawing; they take a few seconds.
inline constexpr std::uint64_t kMostCssComparisons = 100'000'000;
/// Most parts of a selector, with a combinator between each two. Matching is recursive, one level for each part.
inline constexpr std::size_t kMostCssCompounds = 500;

/// Compares the selectors of one drawing with its elements. The drawing must not change meanwhile.
class CssMatcher {
 public:
  /// `path` names the drawing in messages.
  explicit CssMatcher(const std::string& path) : path_(path) {}

  /// Whether the selector selects the element. `element` belongs to the SVG's own document, in which all elements
  /// count, also those that draw nothing. Elements without a name space are SVG elements, as for librsvg. Throws
  /// InputError where all calls together need more than kMostCssComparisons, or the selector has more than
  /// kMostCssCompounds parts.
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
