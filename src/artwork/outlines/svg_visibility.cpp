#include "artwork/outlines/svg_visibility.h"

#include <cstdlib>

#include "artwork/css/css_tokens.h"
#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"

namespace tessera {
namespace {

std::optional<SvgStyle> readable_style(const xmlNode* root, const std::string& path) {
  try {
    return SvgStyle(root, path, css_declarations);
  } catch (const InputError&) {
    return {};
  }
}

/// Whether a number, a length or a percentage is 0. An empty text is none of them.
bool is_zero(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return end != text.c_str() && number <= 0;
}

/// An image without a size has that of its file, and a foreign object without one has none.
bool has_size(const xmlNode* picture) {
  for (const char* side : {"width", "height"}) {
    const std::string length = attribute(picture, side);
    if (is_zero(length) || (length.empty() && name_of(picture) == "foreignObject")) return false;
  }
  return true;
}

}  // namespace

SvgVisibility::SvgVisibility(const xmlNode* root, const std::string& path) : style_(readable_style(root, path)) {}

bool SvgVisibility::shows(const xmlNode* picture) {
  const State state = state_of(picture);
  return state.displayed && state.visible && has_size(picture);
}

/// Recursion is as deep as the document, which parsed_foreign_svg bounds.
SvgVisibility::State SvgVisibility::state_of(const xmlNode* element) {
  if (!element || element->type != XML_ELEMENT_NODE) return {};
  if (const auto known = states_.find(element); known != states_.end()) return known->second;
  State state = state_of(element->parent);
  std::map<std::string, std::string> declared;
  if (style_) declared = counting_values(style_->declarations_of(element));
  const auto value = [&](const char* property) {
    const auto found = declared.find(property);
    const std::string text = found == declared.end() ? attribute(element, property) : without_important(found->second);
    std::string_view rest = text;
    return ascii_lower_case(take_word(rest));
  };
  if (value("display") == "none" || is_zero(value("opacity"))) state.displayed = false;
  const std::string visibility = value("visibility");
  if (visibility == "visible") state.visible = true;
  if (visibility == "hidden" || visibility == "collapse") state.visible = false;
  return states_[element] = state;
}

}  // namespace tessera
