#include "artwork/outlines/svg_masks.h"

#include <optional>
#include <string_view>
#include <unordered_map>

#include "artwork/css/css_tokens.h"
#include "artwork/css/svg_style.h"
#include "artwork/xml/xml_tree.h"

namespace tessera {
namespace {

constexpr std::string_view kMask = "mask";

/// The id that a value names, url(#m) or url("#m"); "" for none.
std::string named_id(const std::string& value) {
  for (const CssToken& token : css_tokens(value)) {
    const bool may_name = token.kind == CssKind::url || token.kind == CssKind::string;
    if (may_name && token.text.starts_with('#')) return token.text.substr(1);
  }
  return "";
}

bool says_mask(const std::string& css) { return ascii_lower_case(css).find(kMask) != std::string::npos; }

/// Of an element and all below it, in the order of the document.
template <class Visit>
void for_each_element(xmlNode* element, const Visit& visit) {
  visit(element);
  for (xmlNode* child = xmlFirstElementChild(element); child; child = xmlNextElementSibling(child))
    for_each_element(child, visit);
}

/// A style sheet or a style attribute that speaks of masks.
bool have_mask_styles(xmlNode* root) {
  bool found = false;
  for_each_element(root, [&](xmlNode* element) {
    found = found || says_mask(attribute(element, "style")) ||
            (name_of(element) == "style" && says_mask(content_of(element)));
  });
  return found;
}

/// The id that a <use> shows: SVG 2's href goes before xlink:href.
std::string shown_id(const xmlNode* use) {
  const std::string plain = attribute(use, "href");
  if (plain.empty()) return reference(use);
  return plain.starts_with('#') ? plain.substr(1) : "";
}

}  // namespace

SvgMasks::SvgMasks(xmlNode* root, const std::string& path) {
  find(root, path);
  for (xmlNode* element : masked_) {
    if (below_.contains(element)) continue;
    for_each_element(element, [&](const xmlNode* inside) { below_.insert(inside); });
  }
  if (!masked_.empty()) mark_what_shows(root);
}

void SvgMasks::find(xmlNode* root, const std::string& path) {
  std::unordered_set<std::string> masks;
  for_each_element(root, [&](const xmlNode* element) {
    if (name_of(element) == kMask) masks.insert(attribute(element, "id"));
  });
  if (masks.empty()) return;
  std::optional<SvgStyle> style;
  if (have_mask_styles(root)) style.emplace(root, path, css_declarations);
  for_each_element(root, [&](xmlNode* element) {
    if (!is_in_svg_namespace(element)) return;
    std::string value = attribute(element, "mask");
    if (style) {
      const auto values = counting_values(style->declarations_of(element));
      if (const auto found = values.find(std::string(kMask)); found != values.end()) value = found->second;
    }
    if (const std::string id = named_id(value); !id.empty() && masks.contains(id)) masked_.push_back(element);
  });
}

void SvgMasks::mark_what_shows(const xmlNode* root) {
  std::unordered_map<std::string, std::vector<const xmlNode*>> uses_of;
  for_each_element(const_cast<xmlNode*>(root), [&](const xmlNode* element) {
    if (name_of(element) == "use") uses_of[shown_id(element)].push_back(element);
  });
  std::vector<const xmlNode*> to_mark(masked_.begin(), masked_.end());
  while (!to_mark.empty()) {
    const xmlNode* node = to_mark.back();
    to_mark.pop_back();
    for (; node && node->type == XML_ELEMENT_NODE && above_.insert(node).second; node = node->parent) {
      const std::string id = attribute(node, "id");
      if (id.empty()) continue;
      for (const xmlNode* use : uses_of[id]) to_mark.push_back(use);
    }
  }
}

bool SvgMasks::touch(const xmlNode* element) const { return below_.contains(element) || above_.contains(element); }

void SvgMasks::take_off() const {
  for (xmlNode* element : masked_) {
    std::vector<CssDeclaration> own = css_declarations(css_tokens(attribute(element, "style")));
    own.push_back({std::string(kMask), "none!important"});
    xmlSetProp(element, xml("style"), xml(css_text_of(own).c_str()));
  }
}

}  // namespace tessera
