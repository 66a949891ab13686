#include "artwork/svg/xml_tree.h"

#include <algorithm>
#include <memory>

#include "core/base/error.h"
#include "text/libxml_state.h"

namespace tessera {
namespace {

std::string taken(xmlChar* text) {
  const std::unique_ptr<xmlChar, FreeXml> owned(text);
  return owned ? reinterpret_cast<const char*>(owned.get()) : "";
}

}  // namespace

XmlDocPtr parsed_svg(std::span<const std::uint8_t> svg, const std::string& path) {
  constexpr int kOptions = XML_PARSE_NONET | XML_PARSE_HUGE | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
  make_libxml_state();
  XmlDocPtr doc(xmlReadMemory(reinterpret_cast<const char*>(svg.data()), int(svg.size()), nullptr, nullptr, kOptions));
  if (!doc || !xmlDocGetRootElement(doc.get())) throw InputError(path + ": not a readable SVG file");
  return doc;
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
