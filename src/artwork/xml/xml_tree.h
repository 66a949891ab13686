// XML that libxml2 has parsed.
#pragma once

#include <libxml/tree.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "artwork/xml/xml_parsing.h"

namespace tessera {

/// An SVG that a program of ours or cairo has written: it is well-formed, and may be huge. Throws InputError.
XmlDocPtr parsed_svg(std::span<const std::uint8_t> svg, const std::string& path);

/// The deepest element of an SVG from strangers: who walks through it calls itself so often.
inline constexpr int kMostXmlLevels = 256;

/// An SVG from strangers, unpacked, its entities put in. libxml2 bounds what entities become, and loads nothing. Throws
/// InputError, naming `path`, where it is not well-formed, its root is no <svg>, or it has more than kMostXmlLevels:
/// libxml2 bounds these in the text, but not in what entities add.
XmlDocPtr parsed_foreign_svg(std::span<const std::uint8_t> svg, const std::string& path);

inline constexpr std::string_view kSvgNamespace = "http://www.w3.org/2000/svg";

/// The document as UTF-8. Its declarations go: entities and defaults stand in the elements by now.
std::string text_of(xmlDoc& doc);

/// As libxml2 takes names.
inline const xmlChar* xml(const char* text) { return reinterpret_cast<const xmlChar*>(text); }

/// "" for null.
std::string_view view(const xmlChar* text);
std::string_view name_of(const xmlNode* node);
/// Elements without a name space count as SVG's, as for librsvg: old files forget the name space.
bool is_in_svg_namespace(const xmlNode* element);
/// Takes the first word off a list with white space between, such as an attribute "class". "" where there is none.
std::string_view take_word(std::string_view& list);
/// The text of an element or attribute, with that of the elements inside.
std::string content_of(const xmlNode* node);
/// "" where there is none.
std::string attribute(const xmlNode* node, const char* name);
/// Its xlink:href.
std::string hyperlink(const xmlNode* node);
/// The id that it names; "" where there is none.
std::string reference(const xmlNode* node);

}  // namespace tessera
