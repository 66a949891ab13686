#include "artwork/outlines/svg_uses.h"

#include <string>
#include <unordered_map>

#include "artwork/xml/xml_tree.h"

namespace tessera {
namespace {

/// The id that a <use> refers to: SVG 2's href takes precedence over xlink:href.
std::string shown_id(const xmlNode* use) {
  const std::string plain = attribute(use, "href");
  if (plain.empty()) return reference(use);
  return plain.starts_with('#') ? plain.substr(1) : "";
}

struct Uses {
  std::unordered_map<std::string, const xmlNode*> first_of_id;
  std::vector<const xmlNode*> all;

  /// Collects ids and uses. The recursion is as deep as the document, which parsed_foreign_svg limits.
  void collect(const xmlNode* element) {
    if (const std::string id = attribute(element, "id"); !id.empty()) first_of_id.emplace(id, element);
    if (name_of(element) == "use") all.push_back(element);
    for (const xmlNode* child = element->children; child; child = child->next) {
      if (child->type == XML_ELEMENT_NODE) collect(child);
    }
  }
};

}  // namespace

std::unordered_set<const xmlNode*> elements_that_show(const std::vector<const xmlNode*>& shown, const xmlNode* root) {
  Uses uses;
  uses.collect(root);
  std::unordered_map<const xmlNode*, std::vector<const xmlNode*>> uses_of;
  for (const xmlNode* use : uses.all) {
    if (const auto target = uses.first_of_id.find(shown_id(use)); target != uses.first_of_id.end())
      uses_of[target->second].push_back(use);
  }
  std::unordered_set<const xmlNode*> showing;
  std::vector<const xmlNode*> left = shown;
  while (!left.empty()) {
    const xmlNode* node = left.back();
    left.pop_back();
    for (; node && node->type == XML_ELEMENT_NODE && showing.insert(node).second; node = node->parent) {
      if (const auto own = uses_of.find(node); own != uses_of.end())
        left.insert(left.end(), own->second.begin(), own->second.end());
    }
  }
  return showing;
}

}  // namespace tessera
