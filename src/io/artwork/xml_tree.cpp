#include "io/artwork/xml_tree.h"

#include "core/base/error.h"

namespace tessera::io {
namespace {

const xmlChar* xml(const char* text) { return reinterpret_cast<const xmlChar*>(text); }

std::string taken(xmlChar* text) {
  const std::unique_ptr<xmlChar, FreeXml> owned(text);
  return owned ? reinterpret_cast<const char*>(owned.get()) : "";
}

}  // namespace

XmlDocPtr parsed_svg(std::span<const std::uint8_t> svg, const std::string& path) {
  constexpr int kOptions = XML_PARSE_NONET | XML_PARSE_HUGE | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
  XmlDocPtr doc(xmlReadMemory(reinterpret_cast<const char*>(svg.data()), int(svg.size()), nullptr, nullptr, kOptions));
  if (!doc || !xmlDocGetRootElement(doc.get())) throw InputError(path + ": not a readable SVG file");
  return doc;
}

std::string_view name_of(const xmlNode* node) { return reinterpret_cast<const char*>(node->name); }

std::string content_of(const xmlNode* node) { return taken(xmlNodeGetContent(node)); }

std::string attribute(const xmlNode* node, const char* name) { return taken(xmlGetNoNsProp(node, xml(name))); }

std::string hyperlink(const xmlNode* node) {
  return taken(xmlGetNsProp(node, xml("href"), xml("http://www.w3.org/1999/xlink")));
}

std::string reference(const xmlNode* node) {
  const std::string uri = hyperlink(node);
  return uri.starts_with('#') ? uri.substr(1) : "";
}

}  // namespace tessera::io
