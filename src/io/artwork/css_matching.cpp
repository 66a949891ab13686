#include "io/artwork/css_matching.h"

#include <algorithm>
#include <string_view>

#include "io/artwork/xml_tree.h"

namespace tessera::io {
namespace {

constexpr std::string_view kSpaces = " \t\r\n\f";

std::string_view view(const xmlChar* text) { return text ? reinterpret_cast<const char*>(text) : ""; }

const xmlNode* parent_of(const xmlNode* node) {
  return node->parent && node->parent->type == XML_ELEMENT_NODE ? node->parent : nullptr;
}

const xmlNode* element_before(const xmlNode* node) {
  do node = node->prev;
  while (node && node->type != XML_ELEMENT_NODE);
  return node;
}

const xmlNode* element_after(const xmlNode* node) {
  do node = node->next;
  while (node && node->type != XML_ELEMENT_NODE);
  return node;
}

bool is_in_svg(const xmlNode* node) { return !node->ns || view(node->ns->href) == kSvgNamespace; }

bool is_of_type(const CssCompound& compound, const xmlNode* node) {
  if (compound.space == CssSpace::none || (compound.space == CssSpace::svg && !is_in_svg(node))) return false;
  return compound.type.empty() || compound.type == view(node->name);
}

bool is_same_type(const xmlNode* a, const xmlNode* b) {
  return view(a->name) == view(b->name) &&
         (is_in_svg(a) ? is_in_svg(b) : b->ns && view(a->ns->href) == view(b->ns->href));
}

/// Calls `found(word)` for the words between spaces until it is true.
template <class Found>
bool any_word(std::string_view text, Found found) {
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
    if (text.empty()) return false;
    const std::string_view word = text.substr(0, text.find_first_of(kSpaces));
    if (found(word)) return true;
    text.remove_prefix(word.size());
  }
}

bool matches(const CssId& wanted, const xmlNode* node) { return attribute(node, "id") == wanted.id; }

bool matches(const CssClass& wanted, const xmlNode* node) {
  return any_word(attribute(node, "class"), [&](std::string_view word) { return word == wanted.name; });
}

bool passes(CssAttribute::Test test, std::string_view value, std::string_view wanted) {
  using Test = CssAttribute::Test;
  switch (test) {
    case Test::exists: return true;
    case Test::equals: return value == wanted;
    case Test::has_word: return any_word(value, [&](std::string_view word) { return word == wanted; });
    case Test::has_language:
      return value.starts_with(wanted) && (value.size() == wanted.size() || value[wanted.size()] == '-');
    case Test::begins: return !wanted.empty() && value.starts_with(wanted);
    case Test::ends: return !wanted.empty() && value.ends_with(wanted);
    case Test::contains: return !wanted.empty() && value.find(wanted) != std::string_view::npos;
  }
  return false;
}

bool matches(const CssAttribute& wanted, const xmlNode* node) {
  for (const xmlAttr* found = node->properties; found; found = found->next) {
    if (view(found->name) != wanted.name || (wanted.space == CssSpace::none && found->ns)) continue;
    const std::string value = content_of(reinterpret_cast<const xmlNode*>(found));
    return wanted.ignores_case ? passes(wanted.test, ascii_lower_case(value), ascii_lower_case(wanted.value))
                               : passes(wanted.test, value, wanted.value);
  }
  return false;
}

bool matches(const CssPlace& place, const xmlNode* node) {
  int number = 1;  // of the element among its siblings
  const auto next = place.from_end ? element_after : element_before;
  for (const xmlNode* other = next(node); other; other = next(other)) {
    if (!place.of_type || is_same_type(other, node)) ++number;
  }
  const int steps = number - place.b;  // a times a whole number that is not negative
  return place.a == 0 ? steps == 0 : steps % place.a == 0 && steps / place.a >= 0;
}

/// xml:lang is inherited.
std::string language_of(const xmlNode* node) {
  for (; node; node = parent_of(node)) {
    for (const xmlAttr* found = node->properties; found; found = found->next) {
      if (view(found->name) == "lang" && found->ns && view(found->ns->href) == view(XML_XML_NAMESPACE)) {
        return ascii_lower_case(content_of(reinterpret_cast<const xmlNode*>(found)));
      }
    }
  }
  return "";
}

bool matches(const CssLanguages& languages, const xmlNode* node) {
  const std::string language = language_of(node);
  return std::any_of(languages.ranges.begin(), languages.ranges.end(), [&](const std::string& range) {
    return !range.empty() && passes(CssAttribute::Test::has_language, language, range);
  });
}

bool is_empty(const xmlNode* node) {
  for (const xmlNode* child = node->children; child; child = child->next) {
    const bool is_text = child->type == XML_TEXT_NODE || child->type == XML_CDATA_SECTION_NODE;
    if (child->type == XML_ELEMENT_NODE || (is_text && !view(child->content).empty())) return false;
  }
  return true;
}

bool is_link(const xmlNode* node) {
  if (view(node->name) != "a" || !is_in_svg(node)) return false;
  return matches(CssAttribute{.space = CssSpace::any, .name = "href"}, node);
}

bool matches(CssState state, const xmlNode* node) {
  switch (state) {
    case CssState::root: return !parent_of(node);
    case CssState::empty: return is_empty(node);
    case CssState::link: return is_link(node);
    case CssState::visited: return false;
  }
  return false;
}

bool matches(const CssNot& negated, const xmlNode* node) {
  return std::none_of(negated.selectors.begin(), negated.selectors.end(),
                      [&](const CssSelector& selector) { return selects(selector, node); });
}

bool matches(const CssCompound& compound, const xmlNode* node) {
  return is_of_type(compound, node) &&
         std::all_of(compound.conditions.begin(), compound.conditions.end(), [&](const CssCondition& condition) {
           return std::visit([&](const auto& kind) { return matches(kind, node); }, condition);
         });
}

/// Whether compounds 0 to `last` match, the last of them `node` itself.
bool matches_up_to(const CssSelector& selector, std::size_t last, const xmlNode* node) {
  if (!matches(selector.compounds[last], node)) return false;
  if (last == 0) return true;
  const CssCombinator combinator = selector.combinators[last - 1];
  const bool upwards = combinator == CssCombinator::descendant || combinator == CssCombinator::child;
  const auto next = upwards ? parent_of : element_before;
  const bool only_one = combinator == CssCombinator::child || combinator == CssCombinator::next;
  for (const xmlNode* other = next(node); other; other = next(other)) {
    if (matches_up_to(selector, last - 1, other)) return true;
    if (only_one) return false;
  }
  return false;
}

}  // namespace

bool selects(const CssSelector& selector, const xmlNode* element) {
  return matches_up_to(selector, selector.compounds.size() - 1, element);
}

}  // namespace tessera::io
