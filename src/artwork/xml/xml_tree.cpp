#include "artwork/xml/xml_tree.h"

#include <algorithm>
#include <memory>
#include <new>

#include "core/base/error.h"
#include "core/base/too_many.h"
#include "text/libxml_state.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

std::string taken(xmlChar* text) {
  const std::unique_ptr<xmlChar, FreeXml> owned(text);
  return owned ? reinterpret_cast<const char*>(owned.get()) : "";
}

/// libxml2's first error: "line 3: Opening and ending tag mismatch"; empty where it reports none.
std::string first_fault(xmlParserCtxt& context) {
  const xmlError* const error = xmlCtxtGetLastError(&context);
  if (!error || !error->message) return "";
  std::string message = error->message;
  while (message.ends_with(' ') || message.ends_with('\n')) message.pop_back();
  return ": line " + std::to_string(error->line) + ": " + cut_utf8(printable_utf8(message), 200);
}

int levels_of(const xmlNode* root) {
  int levels = 1, deepest = 1;
  for (const xmlNode* node = root; node;) {
    if (node->children && node->type == XML_ELEMENT_NODE) {
      node = node->children;
      deepest = std::max(deepest, ++levels);
      continue;
    }
    while (node != root && !node->next) {
      node = node->parent;
      --levels;
    }
    node = node == root ? nullptr : node->next;
  }
  return deepest;
}

}  // namespace

XmlDocPtr parsed_foreign_svg(std::span<const std::uint8_t> svg, const std::string& path) {
  const XmlContextPtr context = new_xml_context();
  context->sax->entityDecl = declare_internal_entity;
  constexpr int kOptions =
      XML_PARSE_NONET | XML_PARSE_NOENT | XML_PARSE_NOCDATA | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
  XmlDocPtr doc = read_xml(*context, svg, kOptions);
  if (!doc) throw InputError(path + ": not a readable SVG file" + first_fault(*context));
  const xmlNode* const root = xmlDocGetRootElement(doc.get());
  if (!root || !is_in_svg_namespace(root) || name_of(root) != "svg") throw InputError(path + ": not an SVG file");
  if (levels_of(root) > kMostXmlLevels)
    throw InputError(path + ": " + too_many(kMostXmlLevels, "levels of elements in each other"));
  return doc;
}

XmlDocPtr parsed_svg(std::span<const std::uint8_t> svg, const std::string& path) {
  constexpr int kOptions = XML_PARSE_NONET | XML_PARSE_HUGE | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
  make_libxml_state();
  XmlDocPtr doc(xmlReadMemory(reinterpret_cast<const char*>(svg.data()), int(svg.size()), nullptr, nullptr, kOptions));
  if (!doc || !xmlDocGetRootElement(doc.get())) throw InputError(path + ": not a readable SVG file");
  return doc;
}

std::string text_of(xmlDoc& doc) {
  if (xmlDtd* const subset = doc.intSubset) {
    xmlUnlinkNode(reinterpret_cast<xmlNode*>(subset));
    xmlFreeDtd(subset);
  }
  xmlChar* bytes = nullptr;
  int size = 0;
  xmlDocDumpMemoryEnc(&doc, &bytes, &size, "UTF-8");
  const std::unique_ptr<xmlChar, FreeXml> owned(bytes);
  if (!owned) throw std::bad_alloc();
  return {reinterpret_cast<const char*>(bytes), std::size_t(size)};
}

std::string_view view(const xmlChar* text) { return text ? reinterpret_cast<const char*>(text) : ""; }

std::string_view name_of(const xmlNode* node) { return view(node->name); }

bool is_in_svg_namespace(const xmlNode* element) { return !element->ns || view(element->ns->href) == kSvgNamespace; }

std::string_view take_word(std::string_view& list) {
  constexpr std::string_view kSpaces = " \t\r\n\f";
  list.remove_prefix(std::min(list.find_first_not_of(kSpaces), list.size()));
  const std::string_view word = list.substr(0, list.find_first_of(kSpaces));
  list.remove_prefix(word.size());
  return word;
}

std::string content_of(const xmlNode* node) { return taken(xmlNodeGetContent(node)); }

std::string attribute(const xmlNode* node, const char* name) { return taken(xmlGetNoNsProp(node, xml(name))); }

std::string hyperlink(const xmlNode* node) {
  return taken(xmlGetNsProp(node, xml("href"), xml("http://www.w3.org/1999/xlink")));
}

std::string reference(const xmlNode* node) {
  const std::string uri = hyperlink(node);
  return uri.starts_with('#') ? uri.substr(1) : "";
}

}  // namespace tessera
