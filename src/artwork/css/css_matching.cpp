#include "artwork/css/css_matching.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"
#include "core/base/too_many.h"

namespace tessera {
namespace {

bool is_of_type(const CssCompound& compound, const xmlNode* node) {
  if (compound.space == CssSpace::none || (compound.space == CssSpace::svg && !is_in_svg_namespace(node))) return false;
  return compound.type.empty() || compound.type == name_of(node);
}

bool has_word(std::string_view text, std::string_view wanted) {
  for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
    if (word == wanted) return true;
  }
  return false;
}

bool passes(CssAttribute::Test test, std::string_view value, std::string_view wanted) {
  using Test = CssAttribute::Test;
  switch (test) {
    case Test::exists: return true;
    case Test::equals: return value == wanted;
    case Test::has_word: return has_word(value, wanted);
    case Test::has_language:
      return value.starts_with(wanted) && (value.size() == wanted.size() || value[wanted.size()] == '-');
    case Test::begins: return !wanted.empty() && value.starts_with(wanted);
    case Test::ends: return !wanted.empty() && value.ends_with(wanted);
    case Test::contains: return !wanted.empty() && value.find(wanted) != std::string_view::npos;
  }
  return false;
}

}  // namespace

void CssMatcher::count(std::uint64_t comparisons) {
  comparisons_ += comparisons;
  if (comparisons_ <= kMostCssComparisons) return;
  throw InputError(path_ + ": its style sheets: " + too_many(kMostCssComparisons, "comparisons with its elements") +
                   "; write styles as attributes, or fewer selectors");
}

/// The parent element; null for the root.
const xmlNode* CssMatcher::element_above(const xmlNode* node) {
  count(1);
  return node->parent && node->parent->type == XML_ELEMENT_NODE ? node->parent : nullptr;
}

/// The sibling element before the node; null for the first one.
const xmlNode* CssMatcher::element_before(const xmlNode* node) {
  do {
    count(1);
    node = node->prev;
  } while (node && node->type != XML_ELEMENT_NODE);
  return node;
}

/// The first attribute with the wanted name; null where there is none.
const xmlAttr* CssMatcher::attribute_of(const xmlNode* node, const CssAttribute& wanted) {
  for (const xmlAttr* found = node->properties; found; found = found->next) {
    count(1);
    if (view(found->name) == wanted.name && (wanted.space == CssSpace::any || !found->ns)) return found;
  }
  return nullptr;
}

/// Counts the reading of a value, which takes as long as many comparisons.
std::string CssMatcher::counted(std::string value) {
  constexpr std::size_t kComparisons = 16, kBytesOfAComparison = 4;
  count(kComparisons + value.size() / kBytesOfAComparison);
  return value;
}

/// The value of the attribute without a name space, also where it is a default of the document type.
std::string CssMatcher::own_attribute(const xmlNode* node, const char* name) {
  for (const xmlAttr* looked_at = node->properties; looked_at; looked_at = looked_at->next) count(1);
  return counted(attribute(node, name));
}

bool CssMatcher::matches(const CssId& wanted, const xmlNode* node) { return own_attribute(node, "id") == wanted.id; }

bool CssMatcher::matches(const CssClass& wanted, const xmlNode* node) {
  return has_word(own_attribute(node, "class"), wanted.name);
}

bool CssMatcher::matches(const CssAttribute& wanted, const xmlNode* node) {
  const xmlAttr* const found = attribute_of(node, wanted);
  if (!found) return false;
  const std::string value = counted(content_of(reinterpret_cast<const xmlNode*>(found)));
  return wanted.ignores_case ? passes(wanted.test, ascii_lower_case(value), ascii_lower_case(wanted.value))
                             : passes(wanted.test, value, wanted.value);
}

bool CssMatcher::matches(const CssPlace& place, const xmlNode* node) {
  const SiblingNumber& numbers = place.of_type ? numbers_.among_same_type(node) : numbers_.among_all(node);
  const int number = place.from_end ? numbers.from_end : numbers.from_start;
  const int steps = number - place.b;  // must be a times a whole number that is not negative
  return place.a == 0 ? steps == 0 : steps % place.a == 0 && steps / place.a >= 0;
}

/// The language of the element; xml:lang is inherited.
std::string CssMatcher::language_of(const xmlNode* node) {
  for (; node; node = element_above(node)) {
    for (const xmlAttr* found = node->properties; found; found = found->next) {
      count(1);
      if (view(found->name) == "lang" && found->ns && view(found->ns->href) == view(XML_XML_NAMESPACE)) {
        return ascii_lower_case(counted(content_of(reinterpret_cast<const xmlNode*>(found))));
      }
    }
  }
  return "";
}

bool CssMatcher::matches(const CssLanguages& languages, const xmlNode* node) {
  const std::string language = language_of(node);
  count(languages.ranges.size());
  return std::any_of(languages.ranges.begin(), languages.ranges.end(), [&](const std::string& range) {
    return !range.empty() && passes(CssAttribute::Test::has_language, language, range);
  });
}

bool CssMatcher::is_empty(const xmlNode* node) {
  for (const xmlNode* child = node->children; child; child = child->next) {
    count(1);
    const bool is_text = child->type == XML_TEXT_NODE || child->type == XML_CDATA_SECTION_NODE;
    if (child->type == XML_ELEMENT_NODE || (is_text && !view(child->content).empty())) return false;
  }
  return true;
}

bool CssMatcher::matches(CssState state, const xmlNode* node) {
  switch (state) {
    case CssState::root: return !element_above(node);
    case CssState::empty: return is_empty(node);
    case CssState::link:
      return name_of(node) == "a" && is_in_svg_namespace(node) &&
             attribute_of(node, {.space = CssSpace::any, .name = "href"});
    case CssState::visited: return false;
  }
  return false;
}

bool CssMatcher::matches(const CssNot& negated, const xmlNode* node) {
  return std::none_of(negated.selectors.begin(), negated.selectors.end(),
                      [&](const CssSelector& selector) { return selects(selector, node); });
}

bool CssMatcher::matches(const CssCompound& compound, const xmlNode* node) {
  count(1);
  return is_of_type(compound, node) &&
         std::all_of(compound.conditions.begin(), compound.conditions.end(), [&](const CssCondition& condition) {
           count(1);
           return std::visit([&](const auto& kind) { return matches(kind, node); }, condition);
         });
}

/// Whether compounds 0 to `last` match, the last one with `node` itself. The answer also says which other nodes cannot
/// match, so that no node is tried again for each combination of nodes below it:
/// - no: another node may match;
/// - not_among_earlier_siblings: no earlier sibling can match, an ancestor may;
/// - nowhere: no ancestor can match, and no sibling of one.
CssMatcher::Match CssMatcher::match_up_to(const CssSelector& selector, std::size_t last, const xmlNode* node) {
  if (!matches(selector.compounds[last], node)) return Match::no;
  if (last == 0) return Match::yes;
  const CssCombinator combinator = selector.combinators[last - 1];
  const bool goes_up = combinator == CssCombinator::descendant || combinator == CssCombinator::child;
  const auto next = [&](const xmlNode* of) { return goes_up ? element_above(of) : element_before(of); };
  for (const xmlNode* other = next(node); other; other = next(other)) {
    const Match match = match_up_to(selector, last - 1, other);
    if (match == Match::yes || match == Match::nowhere) return match;
    if (combinator == CssCombinator::next) return match;
    if (combinator == CssCombinator::child) return Match::not_among_earlier_siblings;  // they have the same parent
    if (combinator == CssCombinator::later && match == Match::not_among_earlier_siblings) return match;
  }
  return goes_up ? Match::nowhere : Match::not_among_earlier_siblings;
}

bool CssMatcher::selects(const CssSelector& selector, const xmlNode* element) {
  if (selector.compounds.size() > kMostCssCompounds) {
    throw InputError(path_ + ": its style sheets have a selector of " + std::to_string(selector.compounds.size()) +
                     " parts, allowed: " + std::to_string(kMostCssCompounds) + "; name a class or an id instead");
  }
  return match_up_to(selector, selector.compounds.size() - 1, element) == Match::yes;
}

}  // namespace tessera
