// Reads XML that libxml2 has parsed.
#pragma once

#include <libxml/tree.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "artwork/xml/xml_parsing.h"

namespace tessera {

/// An SVG that tessera or cairo has written: it is well-formed, and may be huge. Throws InputError.
XmlDocPtr parsed_svg(std::span<const std::uint8_t> svg, const std::string& path);

/// Most levels of a foreign SVG: functions that walk through it recurse once for each level.
inline constexpr int kMostXmlLevels = 256;

/// A foreign SVG, unpacked, with its entities resolved. libxml2 limits the expansion of entities, and loads nothing.
/// Throws InputError, which names `path`, where it is not well-formed, its root is no <svg>, or it has more than
/// kMostXmlLevels: libxml2 limits levels in the text, but not those that entities add.
XmlDocPtr parsed_foreign_svg(std::span<const std::uint8_t> svg, const std::string& path);

inline constexpr std::string_view kSvgNamespace = "http://www.w3.org/2000/svg";

/// The document as UTF-8, without its declarations: entities and defaults are in the elements by now.
std::string text_of(xmlDoc& doc);

/// A name in the type that libxml2 takes.
inline const xmlChar* xml(const char* text) { return reinterpret_cast<const xmlChar*>(text); }

/// "" for null.
std::string_view view(const xmlChar* text);
std::string_view name_of(const xmlNode* node);
/// Whether the element is in SVG's name space. Elements without a name space count, as for librsvg: old files forget
/// it.
bool is_in_svg_namespace(const xmlNode* element);
/// Removes and returns the first word of a list with white space between words, such as an attribute "class". "" where
/// there is none.
std::string_view take_word(std::string_view& list);
/// The text of an element or attribute, with the text of elements inside.
std::string content_of(const xmlNode* node);
/// The value of an attribute; "" where there is none.
std::string attribute(const xmlNode* node, const char* name);
/// The xlink:href of an element; "" where there is none.
std::string hyperlink(const xmlNode* node);
/// The id that the element refers to; "" where there is none.
std::string reference(const xmlNode* node);

}  // namespace tessera
