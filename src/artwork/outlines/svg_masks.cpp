#include "artwork/outlines/svg_masks.h"

#include <optional>
#include <string_view>

#include "artwork/css/css_tokens.h"
#include "artwork/css/svg_style.h"
#include "artwork/outlines/svg_uses.h"
#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"

namespace tessera {
namespace {

constexpr std::string_view kMask = "mask";

/// The target of a value like url(#m) or url("#m"): "#m". Empty where the value has no target.
std::string named(const std::string& value) {
  for (const CssToken& token : css_tokens(value)) {
    if (token.kind == CssKind::url || token.kind == CssKind::string) return token.text;
  }
  return "";
}

/// Whether librsvg accepts this value of the property "mask". It ignores other values, so they must not replace valid
/// ones.
bool is_valid(const CssDeclaration& mask) {
  const std::string value = without_important(mask.value);
  std::string_view rest = value;
  return !named(value).empty() || (take_word(rest) == "none" && take_word(rest).empty());
}

std::vector<CssDeclaration> mask_declarations(CssTokens content) {
  std::vector<CssDeclaration> all = css_declarations(content);
  std::erase_if(all, [](const CssDeclaration& one) { return one.name != kMask || !is_valid(one); });
  return all;
}

/// Calls `visit` for an element and for all elements below it, in the order of the document.
template <class Visit>
void for_each_element(xmlNode* element, const Visit& visit) {
  visit(element);
  for (xmlNode* child = xmlFirstElementChild(element); child; child = xmlNextElementSibling(child))
    for_each_element(child, visit);
}

/// The declarations of the style sheets about masks. Nullopt where the sheets exceed a limit or load other sheets: then
/// kPlainStyle (svg_outlines.cpp) still removes their masks, but the elements are not named.
std::optional<SvgStyle> mask_style(const xmlNode* root, const std::string& path) {
  try {
    return SvgStyle(root, path, mask_declarations);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

SvgMasks::SvgMasks(xmlNode* root, const std::string& path) {
  find(root, path);
  for (xmlNode* element : masked_) {
    if (below_.contains(element)) continue;
    for_each_element(element, [&](const xmlNode* inside) { below_.insert(inside); });
  }
  if (!masked_.empty()) above_ = elements_that_show({masked_.begin(), masked_.end()}, root);
}

void SvgMasks::find(xmlNode* root, const std::string& path) {
  std::unordered_set<std::string> masks;
  for_each_element(root, [&](const xmlNode* element) {
    if (name_of(element) == kMask && is_in_svg_namespace(element)) masks.insert("#" + attribute(element, "id"));
  });
  if (masks.empty()) return;
  std::optional<SvgStyle> style = mask_style(root, path);
  for_each_element(root, [&](xmlNode* element) {
    if (!is_in_svg_namespace(element)) return;
    std::string value = attribute(element, "mask");
    if (style) {
      const auto values = counting_values(style->declarations_of(element));
      if (const auto found = values.find(std::string(kMask)); found != values.end()) value = found->second;
    }
    if (masks.contains(named(value))) masked_.push_back(element);
  });
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
