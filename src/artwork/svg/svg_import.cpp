#include "artwork/svg/svg_import.h"

#include <glib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "artwork/css/css_variables.h"
#include "artwork/css/svg_style.h"
#include "artwork/svg/svg_page.h"
#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"
#include "files/gunzip.h"
#include "files/write_all.h"
#include "text/number_text.h"
#include "text/xml_writer.h"

namespace tessera {
namespace {

constexpr std::string_view kXlinkNamespace = "http://www.w3.org/1999/xlink";

/// The elements that draw. Of links only the content is kept; other elements are dropped with all their content.
// clang-format off
const std::set<std::string_view> kElements = {
    "svg", "g", "a", "defs", "symbol", "use", "switch",                                                   //
    "path", "rect", "circle", "ellipse", "line", "polyline", "polygon", "image",                          //
    "text", "tspan", "textPath", "tref",                                                                  //
    "linearGradient", "radialGradient", "stop", "pattern", "clipPath", "mask", "marker", "filter",        //
    "feBlend", "feColorMatrix", "feComponentTransfer", "feComposite", "feConvolveMatrix",                 //
    "feDiffuseLighting", "feDisplacementMap", "feDistantLight", "feDropShadow", "feFlood", "feFuncA",     //
    "feFuncB", "feFuncG", "feFuncR", "feGaussianBlur", "feImage", "feMerge", "feMergeNode", "feMorphology",  //
    "feOffset", "fePointLight", "feSpecularLighting", "feSpotLight", "feTile", "feTurbulence"};
// clang-format on

bool is_svg_element(const xmlNode* node) {
  return node->type == XML_ELEMENT_NODE && is_in_svg_namespace(node) && kElements.contains(name_of(node));
}

/// The URI of an embedded bitmap, recognised by its first bytes, not by its stated type: an embedded SVG would bring
/// its own scripts and references. Nullopt for any other address.
std::optional<std::string> bitmap_uri(std::string_view uri) {
  static constexpr std::array<std::array<std::string_view, 2>, 4> kTypes = {
      {{"iVBORw0KGgo", "png"}, {"/9j/", "jpeg"}, {"R0lGOD", "gif"}, {"UklGR", "webp"}}};
  if (!uri.starts_with("data:")) return std::nullopt;
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  if (!uri.substr(0, comma).ends_with(";base64")) return std::nullopt;
  std::string base64(uri.substr(comma + 1));
  std::erase_if(base64, [](unsigned char c) { return std::isspace(c); });
  for (const auto& [mark, type] : kTypes) {
    if (base64.starts_with(mark)) return std::string("data:image/").append(type).append(";base64,").append(base64);
  }
  return std::nullopt;
}

bool holds_text(const xmlNode* node) {
  static const std::set<std::string_view> kTextElements = {"text", "tspan", "textPath", "tref"};
  for (; node && view(node->name) == "a"; node = node->parent) {
  }
  return node && kTextElements.contains(view(node->name));
}

bool begins_like_handler(std::string_view name) {
  return name.size() > 2 && (name[0] == 'o' || name[0] == 'O') && (name[1] == 'n' || name[1] == 'N');
}

/// Whether a filter reads what lies beneath the drawing; librsvg supports this, even of the surrounding document.
bool reads_background(const std::string& attribute, const std::string& value) {
  return (attribute == "in" || attribute == "in2") && value.find("Background") != std::string::npos;
}

/// Attributes of the outermost <svg>, which gets a place and a size: those of the page, beyond which nothing is drawn.
const std::set<std::string_view> kPlaced = {"x", "y", "width", "height", "overflow"};

/// Writes the parts of a parsed SVG that are kept.
class Importer {
 public:
  Importer(const xmlNode* root, const std::string& path, const std::string& scope_id, cv::Size2d page_size)
      : root_(root),
        path_(path),
        scope_id_(scope_id),
        prefix_(scope_id + "-"),
        style_(root, path, [this](CssTokens content) { return local_css_declarations(content, prefix_); }),
        page_(page_size) {}

  std::string import() {
    writer_.start("g").attribute("id", scope_id_);
    writer_.start("svg").attribute("width", fixed(page_.width, 6)).attribute("height", fixed(page_.height, 6));
    write_attributes(root_);
    write_children(root_);
    std::string imported = writer_.end().end().finish();
    // This is known only at the end. What lies beneath the drawing is not blended with it.
    if (blends_) imported.insert(imported.find('>'), " style=\"isolation:isolate\"");
    return imported;
  }

 private:
  void write_element(const xmlNode* node) {
    const std::string_view name = view(node->name);
    writer_.start(name != "a" ? std::string(name) : holds_text(node) ? "tspan" : "g");
    write_attributes(node);
    write_children(node);
    writer_.end();
  }

  /// The recursion is as deep as the document, which parsed_foreign_svg limits.
  void write_children(const xmlNode* parent) {
    for (const xmlNode* node = parent->children; node; node = node->next) {
      if (node->type == XML_TEXT_NODE && holds_text(parent)) writer_.text(content_of(node));
      if (is_svg_element(node)) write_element(node);
    }
  }

  bool is_placed(const xmlNode* node, std::string_view name) const { return node == root_ && kPlaced.contains(name); }

  void write_attributes(const xmlNode* node) {
    std::optional<std::string> reference;
    for (const xmlAttr* attribute = node->properties; attribute; attribute = attribute->next) {
      const std::string_view name = view(attribute->name);
      const std::string_view space = attribute->ns ? view(attribute->ns->href) : "";
      const std::string value = content_of(reinterpret_cast<const xmlNode*>(attribute));
      if (name == "href" && (space.empty() || space == kXlinkNamespace)) {
        // In SVG 2 a plain href takes precedence over xlink:href.
        if (!reference || space.empty()) reference = local_reference(node, value);
      } else if (space.empty() && !is_placed(node, name)) {
        write_attribute(std::string(name), value);
      } else if (view(attribute->name) == "space" && space == view(XML_XML_NAMESPACE)) {
        writer_.attribute("xml:space", value);
      }
    }
    if (reference) writer_.attribute("xlink:href", *reference);
    write_style(node);
  }

  void write_attribute(const std::string& name, const std::string& value) {
    // Without style sheets classes have no meaning; the style attribute is written with the declarations of the sheets.
    static const std::set<std::string_view> kDropped = {"src", "base", "class", "style", "version", "baseProfile"};
    if (begins_like_handler(name) || kDropped.contains(name)) return;
    if (reads_background(name, value))
      throw InputError(path_ + ": found a filter of " + value + ", which is that of the document it stands in");
    note_blending(name);
    if (name == "id") {
      writer_.attribute("id", prefix_ + value);
    } else if (const auto local = local_css_value(value, prefix_)) {
      writer_.attribute(name, *local);
    }
  }

  void write_style(const xmlNode* node) {
    std::string style;
    for (const CssDeclaration& declaration : style_.declarations_of(node)) {
      if (is_placed(node, declaration.name)) continue;
      note_blending(declaration.name);
      style += (style.empty() ? "" : ";") + declaration.name + ":" + declaration.value;
    }
    if (!style.empty()) writer_.attribute("style", style);
  }

  void note_blending(const std::string& property) {
    blends_ = blends_ || g_ascii_strcasecmp(property.c_str(), "mix-blend-mode") == 0;
  }

  std::optional<std::string> local_reference(const xmlNode* node, const std::string& uri) const {
    const std::size_t begin = std::min(uri.find_first_not_of(" \t\r\n"), uri.size());
    if (uri.compare(begin, 1, "#") == 0) return std::string("#") + prefix_ + uri.substr(begin + 1);
    const bool takes_bitmaps = view(node->name) == "image" || view(node->name) == "feImage";
    return takes_bitmaps ? bitmap_uri(std::string_view(uri).substr(begin)) : std::nullopt;
  }

  const xmlNode* root_;
  std::string path_;
  std::string scope_id_;
  std::string prefix_;
  SvgStyle style_;
  cv::Size2d page_;
  XmlWriter writer_;
  bool blends_ = false;  // some part blends with what is beneath it
};

}  // namespace

std::string import_svg(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& scope_id,
                       cv::Size2d page_size) {
  std::vector<std::uint8_t> unpacked;
  if (is_gzip(bytes)) bytes = unpacked = gunzip(bytes, path, kMaxSvgBytes);
  const std::optional<std::string> resolved = with_css_variables(bytes, path);
  if (resolved) bytes = bytes_of(*resolved);
  const XmlDocPtr doc = parsed_foreign_svg(bytes, path);
  const xmlNode* root = xmlDocGetRootElement(doc.get());
  return Importer(root, path, scope_id, page_size).import();
}

}  // namespace tessera
