#include "artwork/svg/svg_pieces.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <utility>

#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"

namespace tessera {
namespace {

constexpr const char* kOverlayLayer = "layer-overlay";
constexpr double kOtherPage = 512;  // page of a silhouette, which has none: the size that library build draws

xmlNode* first_element(xmlNode* parent, std::string_view name) {
  xmlNode* child = xmlFirstElementChild(parent);
  while (child && name_of(child) != name) child = xmlNextElementSibling(child);
  return child;
}

std::string text_of(xmlDoc* doc) {
  xmlChar* bytes = nullptr;
  int size = 0;
  xmlDocDumpMemory(doc, &bytes, &size);
  const std::unique_ptr<xmlChar, FreeXml> owned(bytes);
  return {reinterpret_cast<const char*>(bytes), std::size_t(size)};
}

/// The sizes of the drawings' pages, by the drawings' ids.
std::map<std::string, cv::Size2d> pages_of(xmlNode* root) {
  std::map<std::string, cv::Size2d> pages;
  xmlNode* definitions = first_element(root, "defs");
  for (xmlNode* node = definitions ? xmlFirstElementChild(definitions) : nullptr; node;
       node = xmlNextElementSibling(node)) {
    xmlNode* page = name_of(node) == "image" ? node : first_element(node, "svg");
    if (!page) continue;
    const double width = std::atof(attribute(page, "width").c_str());
    const double height = std::atof(attribute(page, "height").c_str());
    if (width > 0 && height > 0) pages[attribute(node, "id")] = {width, height};
  }
  return pages;
}

std::vector<xmlNode*> pieces_of(xmlNode* root) {
  std::vector<xmlNode*> pieces;
  for (xmlNode* layer = xmlFirstElementChild(root); layer; layer = xmlNextElementSibling(layer)) {
    if (!attribute(layer, "id").starts_with("layer-")) continue;
    for (xmlNode* piece = xmlFirstElementChild(layer); piece; piece = xmlNextElementSibling(piece)) {
      if (attribute(piece, "id").starts_with("piece-")) pieces.push_back(piece);
    }
  }
  return pieces;
}

/// The paths of the pieces' clips, by their ids.
std::map<std::string, std::string> clips_of(xmlNode* root) {
  std::map<std::string, std::string> clips;
  xmlNode* definitions = first_element(root, "defs");
  for (xmlNode* node = definitions ? xmlFirstElementChild(definitions) : nullptr; node;
       node = xmlNextElementSibling(node)) {
    xmlNode* path = name_of(node) == "clipPath" ? first_element(node, "path") : nullptr;
    if (path) clips["url(#" + attribute(node, "id") + ")"] = attribute(path, "d");
  }
  return clips;
}

cairo_matrix_t matrix_of(xmlNode* piece) {
  cairo_matrix_t m;
  const std::string text = attribute(piece, "transform");
  if (std::sscanf(text.c_str(), "matrix(%lf %lf %lf %lf %lf %lf)", &m.xx, &m.yx, &m.xy, &m.yy, &m.x0, &m.y0) == 6)
    return m;
  throw InputError(attribute(piece, "id") + ": transform: found \"" + text + "\", allowed: a matrix");
}

/// Moves the piece's parts to the origin, without their clips, and lists them.
void take_apart(xmlNode* piece, const std::map<std::string, cv::Size2d>& pages,
                const std::map<std::string, std::string>& clips, std::vector<SvgPiece>& list) {
  const cairo_matrix_t matrix = matrix_of(piece);
  int number = 0;
  for (xmlNode* use = xmlFirstElementChild(piece); use; use = xmlNextElementSibling(use)) {
    if (name_of(use) != "use") continue;
    const std::string id = attribute(piece, "id") + "-" + std::to_string(number++);
    const auto page = pages.find(reference(use));
    const auto clip = clips.find(attribute(use, "clip-path"));
    list.push_back({.id = id,
                    .document_from_piece = matrix,
                    .page = page == pages.end() ? cv::Size2d(kOtherPage, kOtherPage) : page->second,
                    .clip = clip == clips.end() ? "" : clip->second});
    xmlSetProp(use, xml("id"), xml(id.c_str()));
    xmlUnsetProp(use, xml("clip-path"));
  }
  xmlUnsetProp(piece, xml("transform"));
}

xmlNode* overlay_of(xmlNode* root) {
  xmlNode* layer = xmlFirstElementChild(root);
  while (layer && attribute(layer, "id") != kOverlayLayer) layer = xmlNextElementSibling(layer);
  return layer;
}

void remove_pieces_and_overlay(xmlNode* root) {
  std::vector<xmlNode*> above_ground = pieces_of(root);
  if (xmlNode* overlay = overlay_of(root)) above_ground.push_back(overlay);
  for (xmlNode* node : above_ground) {
    xmlUnlinkNode(node);
    xmlFreeNode(node);
  }
}

void remove_page(xmlNode* root) {
  for (const char* name : {"viewBox", "width", "height"}) xmlUnsetProp(root, xml(name));
  xmlSetProp(root, xml("overflow"), xml("visible"));
}

}  // namespace

DividedSvg divided_svg(std::span<const std::uint8_t> svg, const std::string& path) {
  const XmlDocPtr doc = parsed_svg(svg, path);
  xmlNode* root = xmlDocGetRootElement(doc.get());
  DividedSvg divided;
  std::sscanf(attribute(root, "viewBox").c_str(), "%*f %*f %lf %lf", &divided.size.width, &divided.size.height);
  const XmlDocPtr ground(xmlCopyDoc(doc.get(), 1));
  remove_pieces_and_overlay(xmlDocGetRootElement(ground.get()));
  divided.ground = text_of(ground.get());
  const auto pages = pages_of(root);
  const auto clips = clips_of(root);
  for (xmlNode* piece : pieces_of(root)) take_apart(piece, pages, clips, divided.list);
  if (overlay_of(root)) {
    cairo_matrix_t where_it_is;
    cairo_matrix_init_identity(&where_it_is);
    divided.list.push_back({.id = kOverlayLayer, .document_from_piece = where_it_is, .page = divided.size, .clip = ""});
  }
  remove_page(root);
  divided.pieces = text_of(doc.get());
  return divided;
}

}  // namespace tessera
