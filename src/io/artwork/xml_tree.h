// XML that libxml2 has parsed.
#pragma once

#include <libxml/parser.h>
#include <libxml/tree.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace tessera::io {

struct FreeXml {
  void operator()(xmlDoc* doc) const { xmlFreeDoc(doc); }
  void operator()(xmlChar* text) const { xmlFree(text); }
};
using XmlDocPtr = std::unique_ptr<xmlDoc, FreeXml>;

/// An SVG that a program of ours or cairo has written: it is well-formed, and may be huge. Throws InputError.
XmlDocPtr parsed_svg(std::span<const std::uint8_t> svg, const std::string& path);

inline constexpr std::string_view kSvgNamespace = "http://www.w3.org/2000/svg";

std::string_view name_of(const xmlNode* node);
/// The text of an element or attribute, with that of the elements inside.
std::string content_of(const xmlNode* node);
/// "" where there is none.
std::string attribute(const xmlNode* node, const char* name);
/// Its xlink:href.
std::string hyperlink(const xmlNode* node);
/// The id that it names; "" where there is none.
std::string reference(const xmlNode* node);

}  // namespace tessera::io
