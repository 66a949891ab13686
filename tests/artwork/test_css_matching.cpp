// Matching of selectors gives the same result as trying each combination of elements.
#include "artwork/css/css_matching.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "artwork/css/css_tokens.h"
#include "artwork/xml/xml_tree.h"

namespace tessera {
namespace test_css_matching {

const xmlNode* element_before(const xmlNode* node) {
  do node = node->prev;
  while (node && node->type != XML_ELEMENT_NODE);
  return node;
}

const xmlNode* parent_of(const xmlNode* node) {
  return node->parent->type == XML_ELEMENT_NODE ? node->parent : nullptr;
}

/// Tries all combinations. Compounds consist only of types.
bool selects_by_trying(const CssSelector& selector, std::size_t last, const xmlNode* node) {
  const std::string& type = selector.compounds[last].type;
  if (!type.empty() && type != name_of(node)) return false;
  if (last == 0) return true;
  const CssCombinator combinator = selector.combinators[last - 1];
  const bool goes_up = combinator == CssCombinator::descendant || combinator == CssCombinator::child;
  const auto next = goes_up ? parent_of : element_before;
  for (const xmlNode* other = next(node); other; other = next(other)) {
    if (selects_by_trying(selector, last - 1, other)) return true;
    if (combinator == CssCombinator::child || combinator == CssCombinator::next) return false;
  }
  return false;
}

std::string random_tree(int levels) {
  std::string tree;
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    const std::string name = *rc::gen::element<std::string>("a", "b", "c");
    tree += "<" + name + ">" + (levels > 0 ? random_tree(levels - 1) : "") + "</" + name + ">";
  }
  return tree;
}

std::string random_selector() {
  std::string selector = "*";
  for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
    selector += *rc::gen::element<std::string>(" ", " > ", " + ", " ~ ");
    selector += *rc::gen::element<std::string>("*", "a", "b", "c");
  }
  return selector;
}

int compare_below(CssMatcher& matcher, const CssSelector& selector, const xmlNode* node) {
  int selected = 0;
  for (; node; node = node->next) {
    const bool wanted = selects_by_trying(selector, selector.compounds.size() - 1, node);
    RC_ASSERT(matcher.selects(selector, node) == wanted);
    selected += wanted + compare_below(matcher, selector, node->children);
  }
  return selected;
}

RC_GTEST_PROP(CssMatching, SelectsWhatEachCombinationSelects, ()) {
  const std::string text = "<svg>" + random_tree(4) + "</svg>";
  const XmlDocPtr tree = parsed_svg({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "tree");
  const std::string selector = random_selector();
  const auto selectors = parse_css_selectors(css_tokens(selector));
  RC_ASSERT(selectors.has_value());
  CssMatcher matcher("tree");
  const int selected = compare_below(matcher, selectors->front(), xmlDocGetRootElement(tree.get()));
  RC_CLASSIFY(selected > 0);
}

/// Positions among siblings, also with elements of other name spaces and text between them.
TEST(CssMatching, PlacesAmongSiblings) {
  const std::string text =
      "<svg xmlns:o='urn:o' xmlns:s='http://www.w3.org/2000/svg'>x<a/><b/><!-- --><s:a/><o:a/>y<a/></svg>";
  const XmlDocPtr tree = parsed_svg({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "tree");
  const auto selected = [&](const std::string& selector) {
    CssMatcher matcher("tree");
    const auto selectors = parse_css_selectors(css_tokens(selector));
    std::string places;
    int place = 0;
    for (const xmlNode* node = xmlDocGetRootElement(tree.get())->children; node; node = node->next) {
      if (node->type != XML_ELEMENT_NODE) continue;
      places += matcher.selects(selectors->front(), node) ? std::to_string(place) : "";
      ++place;
    }
    return places;
  };
  EXPECT_EQ(selected("*|*:nth-child(2n+1)"), "024");
  EXPECT_EQ(selected("*|*:nth-last-child(-n+2)"), "34");
  EXPECT_EQ(selected("*|*:nth-of-type(1)"), "013");
  EXPECT_EQ(selected("a:nth-of-type(2)"), "2");
  EXPECT_EQ(selected("a:nth-last-of-type(3)"), "0");
  EXPECT_EQ(selected("*|*:only-of-type"), "13");
}

}  // namespace test_css_matching
}  // namespace tessera
