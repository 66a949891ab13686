#include "artwork/outlines/drawing_elements.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <unordered_map>

#include "artwork/css/svg_style.h"
#include "artwork/outlines/svg_masks.h"
#include "artwork/outlines/svg_outlines.h"
#include "artwork/outlines/svg_pictures.h"
#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"
#include "core/base/too_many.h"

namespace tessera {
namespace {

const std::set<std::string_view> kGroups = {"svg", "g", "a", "switch"};
const std::set<std::string_view> kShapes = {"path", "rect", "circle", "ellipse", "polygon", "polyline", "line", "use"};
const std::set<std::string_view> kPictures = {"image", "foreignObject"};

bool is_drawn_kind(const xmlNode* node) {
  const std::string_view kind = name_of(node);
  return is_in_svg_namespace(node) &&
         (kGroups.contains(kind) || kShapes.contains(kind) || kPictures.contains(kind) || kind == "text");
}

/// The version number (digits and dots) after the text `before`.
std::string version_after(std::string_view text, std::string_view before) {
  const std::size_t at = text.find(before);
  if (at == std::string_view::npos) return "";
  std::size_t end = at + before.size();
  while (end < text.size() && (std::isdigit(static_cast<unsigned char>(text[end])) || text[end] == '.')) ++end;
  return std::string(text.substr(at + before.size(), end - at - before.size()));
}

std::string program_of(const xmlDoc* doc, const xmlNode* root) {
  constexpr std::string_view kInkscape = "http://www.inkscape.org/namespaces/inkscape";
  for (const xmlAttr* a = root->properties; a; a = a->next) {
    if (a->ns && view(a->ns->href) == kInkscape && view(a->name) == "version")
      return "Inkscape " + version_after(content_of(reinterpret_cast<const xmlNode*>(a)), "");
  }
  for (const xmlNode* node = doc->children; node; node = node->next) {
    if (node->type != XML_COMMENT_NODE || view(node->content).find("Adobe Illustrator") == std::string_view::npos)
      continue;
    return "Adobe Illustrator " + version_after(view(node->content), "Adobe Illustrator ");
  }
  return "";
}

/// The child that a <switch> shows: the first that requires neither another program nor a language.
xmlNode* chosen_of(xmlNode* one_of_many) {
  xmlNode* of_a_language = nullptr;
  for (xmlNode* node = xmlFirstElementChild(one_of_many); node; node = xmlNextElementSibling(node)) {
    if (!is_drawn_kind(node) || xmlHasNsProp(node, xml("requiredExtensions"), nullptr)) continue;
    if (!xmlHasNsProp(node, xml("systemLanguage"), nullptr)) return node;
    if (!of_a_language) of_a_language = node;
  }
  return of_a_language;
}

/// Makes a pattern fill its whole area, whatever it shows: a pattern whose picture is not read would be no fill at all.
void fill_whole(xmlNode* pattern) {
  xmlNode* const all = xmlNewChild(pattern, pattern->ns, xml("path"), nullptr);
  xmlSetProp(all, xml("d"), xml("M-1e4-1e4H1e4V1e4H-1e4z"));
  xmlSetProp(all, xml("style"), xml("fill:#000!important;stroke:none!important;display:inline!important"));
}

/// Finds the leaves, and the changes with which librsvg draws each of them as a layer. Each leaf gets an id of its own,
/// as librsvg takes the first element with the id. Each <switch> becomes a group with one visible child, as librsvg
/// 2.54 draws a layer in a <switch> wrongly or not at all.
class LeafFinder {
 public:
  LeafFinder(xmlNode* root, const std::string& path)
      : path_(path),
        root_(root),
        masks_(root, path),
        pictures_(root, path) {
    collect_ids(root);
    add_children(root);
  }

  /// Makes all changes once all leaves are found: selectors test ids and neighbouring elements.
  void change() const {
    const bool replaces_ids = std::any_of(new_ids_.begin(), new_ids_.end(), [](const NewId& id) { return id.had_one; });
    std::vector<std::string> styles(new_ids_.size());
    if (replaces_ids) {
      SvgStyle style(root_, path_, css_declarations);
      for (std::size_t i = 0; i < new_ids_.size(); ++i) {
        if (new_ids_[i].had_one) styles[i] = css_text_of(style.declarations_of(new_ids_[i].node));
      }
    }
    for (std::size_t i = 0; i < new_ids_.size(); ++i) {
      xmlSetProp(new_ids_[i].node, xml("id"), xml(new_ids_[i].id.c_str()));
      if (!styles[i].empty()) xmlSetProp(new_ids_[i].node, xml("style"), xml(styles[i].c_str()));
    }
    masks_.take_off();
    for (xmlNode* node : patterns_) fill_whole(node);
    for (xmlNode* node : hidden_) xmlSetProp(node, xml("style"), xml("display:none!important"));
    for (xmlNode* node : switches_) xmlNodeSetName(node, xml("g"));
  }

  std::vector<DrawingElement> take() { return std::move(leaves_); }

 private:
  struct NewId {
    xmlNode* node;
    std::string id;
    bool had_one;  // a style may depend on the old id
  };

  /// Collects the ids. The recursion is as deep as the document, which parsed_foreign_svg limits.
  void collect_ids(xmlNode* node) {
    if (const std::string id = attribute(node, "id"); !id.empty()) first_of_id_.emplace(id, node);
    if (name_of(node) == "pattern" && xmlFirstElementChild(node)) patterns_.push_back(node);
    for (xmlNode* child = xmlFirstElementChild(node); child; child = xmlNextElementSibling(child)) collect_ids(child);
  }

  void add_children(xmlNode* parent) {
    const bool is_switch = name_of(parent) == "switch";
    xmlNode* const chosen = is_switch ? chosen_of(parent) : nullptr;
    if (is_switch) switches_.push_back(parent);
    for (xmlNode* node = xmlFirstElementChild(parent); node; node = xmlNextElementSibling(node)) {
      if (!is_drawn_kind(node)) continue;
      if (!is_switch || node == chosen)
        add(node);
      else
        hidden_.push_back(node);
    }
  }

  void add(xmlNode* node) {
    const std::string_view kind = name_of(node);
    const std::string own = attribute(node, "id");
    const std::string name = own.empty() ? std::string(kind) + std::to_string(++unnamed_) : own;
    if (kGroups.contains(kind)) return add_children(node);
    std::string id = own;
    // librsvg takes the text before a '#' for a file name.
    if (own.empty() || first_of_id_.at(own) != node || own.find('#') != std::string::npos) {
      do id = "leaf-" + std::to_string(++made_);
      while (first_of_id_.contains(id));
      new_ids_.push_back({node, id, !own.empty()});
    }
    leaves_.push_back({.id = id,
                       .name = name,
                       .is_masked = masks_.touch(node),
                       .is_shape = kShapes.contains(kind),
                       .is_text = kind == "text",
                       .shows_picture = pictures_.shown_by(node)});
    if (leaves_.size() > kMostOutlineElements)
      throw InputError(path_ + ": " + too_many(kMostOutlineElements, "elements that are drawn"));
  }

  std::string path_;
  xmlNode* root_;
  SvgMasks masks_;
  SvgPictures pictures_;
  std::vector<DrawingElement> leaves_;
  std::unordered_map<std::string, const xmlNode*> first_of_id_;
  std::vector<NewId> new_ids_;
  std::vector<xmlNode*> hidden_, switches_, patterns_;
  std::size_t made_ = 0;
  int unnamed_ = 0;
};

}  // namespace

DrawingElements drawing_elements(std::span<const std::uint8_t> bytes, const std::string& path) {
  const XmlDocPtr doc = parsed_foreign_svg(bytes, path);
  xmlNode* const root = xmlDocGetRootElement(doc.get());
  LeafFinder finder(root, path);
  finder.change();
  DrawingElements leaves;
  leaves.list = finder.take();
  for (const char* side : {"width", "height"}) {
    const std::string length = attribute(root, side);
    leaves.says_px = leaves.says_px || length.find("px") != std::string::npos;
  }
  leaves.program = program_of(doc.get(), root);
  leaves.text = text_of(*doc);
  return leaves;
}

}  // namespace tessera
