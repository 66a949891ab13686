#include "artwork/css/sibling_numbers.h"

#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "artwork/xml/xml_tree.h"

namespace tessera {
namespace {

using Type = std::pair<std::string_view, std::string_view>;  // name space and name

Type type_of(const xmlNode* element) {
  return {is_in_svg_namespace(element) ? kSvgNamespace : view(element->ns->href), name_of(element)};
}

std::vector<const xmlNode*> siblings_of(const xmlNode* element) {
  const xmlNode* first = element;
  while (first->prev) first = first->prev;
  std::vector<const xmlNode*> siblings;
  for (const xmlNode* node = first; node; node = node->next) {
    if (node->type == XML_ELEMENT_NODE) siblings.push_back(node);
  }
  return siblings;
}

}  // namespace

const SiblingNumbers::Both& SiblingNumbers::both(const xmlNode* element) {
  if (!numbers_.contains(element)) count_siblings_of(element);
  return numbers_.at(element);
}

void SiblingNumbers::count_siblings_of(const xmlNode* element) {
  const std::vector<const xmlNode*> siblings = siblings_of(element);
  std::map<Type, int> of_type;
  int all = 0;
  for (const xmlNode* sibling : siblings) {
    Both& numbers = numbers_[sibling];
    numbers.among_all.from_start = ++all;
    numbers.among_same_type.from_start = ++of_type[type_of(sibling)];
  }
  for (const xmlNode* sibling : siblings) {
    Both& numbers = numbers_[sibling];
    numbers.among_all.from_end = all + 1 - numbers.among_all.from_start;
    numbers.among_same_type.from_end = of_type[type_of(sibling)] + 1 - numbers.among_same_type.from_start;
  }
}

}  // namespace tessera
