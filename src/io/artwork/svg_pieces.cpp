#include "io/artwork/svg_pieces.h"

#include <libxml/parser.h>
#include <libxml/tree.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <utility>

#include "core/base/error.h"

namespace tessera::io {
namespace {

constexpr double kOtherPage = 512;  // of a silhouette, which has none: as large as library build draws

struct FreeXml {
  void operator()(xmlDoc* doc) const { xmlFreeDoc(doc); }
  void operator()(xmlChar* text) const { xmlFree(text); }
};
using DocPtr = std::unique_ptr<xmlDoc, FreeXml>;

const xmlChar* xml(const char* text) { return reinterpret_cast<const xmlChar*>(text); }
std::string_view name_of(const xmlNode* node) { return reinterpret_cast<const char*>(node->name); }

std::string attribute(xmlNode* node, const char* name) {
  const std::unique_ptr<xmlChar, FreeXml> value(xmlGetNoNsProp(node, xml(name)));
  return value ? reinterpret_cast<const char*>(value.get()) : "";
}

std::string reference(xmlNode* use) {
  const std::unique_ptr<xmlChar, FreeXml> value(xmlGetNsProp(use, xml("href"), xml("http://www.w3.org/1999/xlink")));
  return value ? reinterpret_cast<const char*>(value.get()) + 1 : "";
}

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
  for (xmlNode* node = definitions ? xmlFirstElementChild(definitions) : nullptr; node; node = xmlNextElementSibling(node)) {
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

SvgPiece piece_of(xmlNode* node, const std::map<std::string, cv::Size2d>& pages) {
  SvgPiece piece{.id = attribute(node, "id"), .document_from_piece = {}, .page = {kOtherPage, kOtherPage}};
  cairo_matrix_t& m = piece.document_from_piece;
  const std::string transform = attribute(node, "transform");
  if (std::sscanf(transform.c_str(), "matrix(%lf %lf %lf %lf %lf %lf)", &m.xx, &m.yx, &m.xy, &m.yy, &m.x0, &m.y0) != 6) {
    throw InputError(piece.id + ": transform: found \"" + transform + "\", allowed: a matrix");
  }
  if (xmlNode* use = first_element(node, "use")) {
    if (const auto page = pages.find(reference(use)); page != pages.end()) piece.page = page->second;
  }
  return piece;
}

DocPtr parsed(std::span<const std::uint8_t> svg, const std::string& path) {
  constexpr int kOptions = XML_PARSE_NONET | XML_PARSE_HUGE | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
  DocPtr doc(xmlReadMemory(reinterpret_cast<const char*>(svg.data()), int(svg.size()), nullptr, nullptr, kOptions));
  if (!doc || !xmlDocGetRootElement(doc.get())) throw InputError(path + ": not a readable SVG file");
  return doc;
}

void remove_pieces(xmlNode* root) {
  for (xmlNode* piece : pieces_of(root)) {
    xmlUnlinkNode(piece);
    xmlFreeNode(piece);
  }
}

void lay_pieces_at_origin(xmlNode* root) {
  for (xmlNode* piece : pieces_of(root)) xmlUnsetProp(piece, xml("transform"));
  for (const char* name : {"viewBox", "width", "height"}) xmlUnsetProp(root, xml(name));
  xmlSetProp(root, xml("overflow"), xml("visible"));
}

}  // namespace

DividedSvg divided_svg(std::span<const std::uint8_t> svg, const std::string& path) {
  const DocPtr doc = parsed(svg, path);
  xmlNode* root = xmlDocGetRootElement(doc.get());
  DividedSvg divided;
  std::sscanf(attribute(root, "viewBox").c_str(), "%*f %*f %lf", &divided.width);
  const auto pages = pages_of(root);
  for (xmlNode* piece : pieces_of(root)) divided.list.push_back(piece_of(piece, pages));
  const DocPtr ground(xmlCopyDoc(doc.get(), 1));
  remove_pieces(xmlDocGetRootElement(ground.get()));
  divided.ground = text_of(ground.get());
  lay_pieces_at_origin(root);
  divided.pieces = text_of(doc.get());
  return divided;
}

}  // namespace tessera::io
