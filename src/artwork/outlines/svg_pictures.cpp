#include "artwork/outlines/svg_pictures.h"

#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "artwork/css/css_tokens.h"
#include "artwork/css/svg_style.h"
#include "artwork/outlines/svg_uses.h"
#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"

namespace tessera {
namespace {

constexpr std::string_view kForeignObject = "foreignObject";

std::string first_word(const std::string& value) {
  std::string_view rest = value;
  return ascii_lower_case(take_word(rest));
}

/// The number at the beginning of a length or a percentage.
std::optional<double> leading_number(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return end == text.c_str() ? std::nullopt : std::optional(number);
}

/// Whether librsvg accepts this value of a property that decides about visibility. It ignores other values, so they
/// must not replace valid ones.
bool is_valid(const std::string& property, const std::string& value) {
  static const std::set<std::string> kDisplays = {"inline",
                                                  "block",
                                                  "list-item",
                                                  "run-in",
                                                  "compact",
                                                  "marker",
                                                  "table",
                                                  "inline-table",
                                                  "table-row-group",
                                                  "table-header-group",
                                                  "table-row",
                                                  "table-footer-group",
                                                  "table-column",
                                                  "table-cell",
                                                  "table-column-group",
                                                  "table-caption",
                                                  "none",
                                                  "inherit"};
  static const std::set<std::string> kVisibilities = {"visible", "hidden", "collapse", "inherit"};
  if (property == "display") return kDisplays.contains(first_word(value));
  if (property == "visibility") return kVisibilities.contains(first_word(value));
  return (property == "opacity" || property == "width" || property == "height") && leading_number(value);
}

std::vector<CssDeclaration> declarations_about_sight(CssTokens content) {
  std::vector<CssDeclaration> all = css_declarations(content);
  std::erase_if(all, [](const CssDeclaration& one) { return !is_valid(one.name, without_important(one.value)); });
  return all;
}

/// Searches a document for the visible pictures.
class PictureSearch {
 public:
  PictureSearch(const xmlNode* root, const std::string& path) : root_(root), path_(path) {}

  std::vector<const xmlNode*> found() {
    search(root_, true);
    return std::move(pictures_);
  }

 private:
  using Values = std::map<std::string, std::string>;

  static bool is_picture(const xmlNode* element) {
    return is_in_svg_namespace(element) && (name_of(element) == "image" || name_of(element) == kForeignObject);
  }

  /// The properties that style sheets and the style attribute give the element.
  Values declared(const xmlNode* element) {
    try {
      if (!style_ && sheets_count_) style_.emplace(root_, path_, declarations_about_sight);
      if (style_) return counting_values(style_->declarations_of(element));
    } catch (const InputError&) {
      style_.reset();
      sheets_count_ = false;
    }
    const std::vector<CssToken> own = css_tokens(attribute(element, "style"));
    return counting_values(declarations_about_sight(own));
  }

  static std::string value_of(const xmlNode* element, const Values& declared, const char* property) {
    const auto found = declared.find(property);
    if (found != declared.end()) return without_important(found->second);
    const std::string own = attribute(element, property);
    return is_valid(property, own) ? own : "";
  }

  /// Whether the picture has a size. An image without one has that of its file, a foreign object without one has none.
  static bool has_size(const xmlNode* picture, const Values& declared) {
    for (const char* side : {"width", "height"}) {
      const std::optional<double> length = leading_number(value_of(picture, declared, side));
      if (length ? *length <= 0 : name_of(picture) == kForeignObject) return false;
    }
    return true;
  }

  /// Searches below the element. The recursion is as deep as the document, which parsed_foreign_svg limits.
  void search(const xmlNode* element, bool visible) {
    const Values declared = this->declared(element);
    if (first_word(value_of(element, declared, "display")) == "none") return;
    if (leading_number(value_of(element, declared, "opacity")).value_or(1) <= 0) return;
    const std::string visibility = first_word(value_of(element, declared, "visibility"));
    if (visibility == "visible") visible = true;
    if (visibility == "hidden" || visibility == "collapse") visible = false;
    if (is_picture(element)) {
      if (visible && has_size(element, declared)) pictures_.push_back(element);
      return;
    }
    for (const xmlNode* child = element->children; child; child = child->next) {
      if (child->type == XML_ELEMENT_NODE) search(child, visible);
    }
  }

  const xmlNode* root_;
  const std::string& path_;
  bool sheets_count_ = true;
  std::optional<SvgStyle> style_;
  std::vector<const xmlNode*> pictures_;
};

/// Whether there is any picture: most drawings have none, and reading style sheets takes time.
bool has_picture(const xmlNode* element) {
  const std::string_view name = name_of(element);
  if (name == "image" || name == kForeignObject) return true;
  for (const xmlNode* child = element->children; child; child = child->next) {
    if (child->type == XML_ELEMENT_NODE && has_picture(child)) return true;
  }
  return false;
}

}  // namespace

SvgPictures::SvgPictures(const xmlNode* root, const std::string& path) {
  if (has_picture(root)) showing_ = elements_that_show(PictureSearch(root, path).found(), root);
}

}  // namespace tessera
