#include "artwork/outlines/svg_leaves.h"

#include <cctype>
#include <set>
#include <string_view>
#include <unordered_set>

#include "artwork/outlines/svg_outlines.h"
#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"
#include "core/base/too_many.h"

namespace tessera {
namespace {

const std::set<std::string_view> kGroups = {"svg", "g", "a", "switch"};
const std::set<std::string_view> kShapes = {"path", "rect", "circle", "ellipse", "polygon", "polyline", "line", "use"};
const std::set<std::string_view> kOthers = {"text", "image", "foreignObject"};

/// The word after `before`, as far as it is made of digits and dots.
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

/// Gives ids to leaves. One that several elements have becomes that of the first alone, which is the one that
/// references find.
class Numberer {
 public:
  explicit Numberer(const std::string& path) : path_(path) {}

  /// Recursion is as deep as the document, which libxml2 bounds (256).
  void collect_ids(const xmlNode* node) {
    if (const std::string id = attribute(node, "id"); !id.empty()) ids_.insert(id);
    for (const xmlNode* child = first_element(node); child; child = next_element(child)) collect_ids(child);
  }

  void number(xmlNode* parent) {
    if (name_of(parent) == "switch") make_group(parent);
    for (xmlNode* node = xmlFirstElementChild(parent); node; node = xmlNextElementSibling(node)) {
      if (is_in_svg_namespace(node)) number_one(node);
    }
  }

  std::vector<SvgLeaf> take() { return std::move(leaves_); }

 private:
  static const xmlNode* first_element(const xmlNode* node) { return xmlFirstElementChild(const_cast<xmlNode*>(node)); }
  static const xmlNode* next_element(const xmlNode* node) { return xmlNextElementSibling(const_cast<xmlNode*>(node)); }

  void number_one(xmlNode* node) {
    const std::string_view kind = name_of(node);
    const bool is_group = kGroups.contains(kind), is_shape = kShapes.contains(kind);
    if (!is_group && !is_shape && !kOthers.contains(kind)) return;
    const std::string own = attribute(node, "id");
    const std::string name = own.empty() ? std::string(kind) + std::to_string(++unnamed_) : own;
    if (is_group)
      number(node);
    else
      add(node, own, name, is_shape);
  }

  /// A <switch> shows its first child that is neither for other programs nor for readers of one language. Of a layer
  /// in a <switch> librsvg 2.54 draws nothing, or another child.
  static void make_group(xmlNode* one_of_many) {
    bool found = false;
    for (xmlNode *node = xmlFirstElementChild(one_of_many), *next = nullptr; node; node = next) {
      next = xmlNextElementSibling(node);
      const bool is_chosen = !found && !xmlHasNsProp(node, xml("requiredExtensions"), nullptr) &&
                             !xmlHasNsProp(node, xml("systemLanguage"), nullptr);
      found = found || is_chosen;
      if (is_chosen) continue;
      xmlUnlinkNode(node);
      xmlFreeNode(node);
    }
    xmlNodeSetName(one_of_many, xml("g"));
  }

  void add(xmlNode* node, const std::string& own, const std::string& name, bool is_shape) {
    std::string id = own;
    if (own.empty() || !taken_.insert(own).second) {
      do id = "leaf-" + std::to_string(++made_);
      while (ids_.contains(id));
      xmlSetProp(node, xml("id"), xml(id.c_str()));
    }
    leaves_.push_back({id, name, is_shape});
    if (leaves_.size() > kMostOutlineElements)
      throw InputError(path_ + ": " + too_many(kMostOutlineElements, "elements that are drawn"));
  }

  std::string path_;
  std::vector<SvgLeaf> leaves_;
  std::unordered_set<std::string> ids_, taken_;
  std::size_t made_ = 0;
  int unnamed_ = 0;
};

}  // namespace

SvgLeaves svg_leaves(std::span<const std::uint8_t> bytes, const std::string& path) {
  const XmlDocPtr doc = parsed_foreign_svg(bytes, path);
  xmlNode* const root = xmlDocGetRootElement(doc.get());
  Numberer numberer(path);
  numberer.collect_ids(root);
  numberer.number(root);
  SvgLeaves leaves;
  leaves.list = numberer.take();
  for (const char* side : {"width", "height"}) {
    const std::string length = attribute(root, side);
    leaves.says_px = leaves.says_px || length.find("px") != std::string::npos;
  }
  leaves.program = program_of(doc.get(), root);
  leaves.text = text_of(*doc);
  return leaves;
}

}  // namespace tessera
