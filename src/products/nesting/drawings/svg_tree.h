// The elements of a foreign SVG as libxml2's tree, with bounds on how much of them there may be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "artwork/svg/xml_parsing.h"

namespace tessera {

using SvgTree = XmlDocPtr;

/// What an SVG may have. Drawings of 200,000 points, which is as much as is read of them, have a tenth of this. The
/// whole takes some 300 MB at most.
namespace svg_limits {
inline constexpr std::size_t kBytes = std::size_t(64) << 20;  // unpacked
inline constexpr std::size_t kElements = 100'000;
inline constexpr std::size_t kLevels = 250;                 // a few less than libxml2 reads
inline constexpr std::size_t kAttributes = 400'000;         // name spaces are some, too
inline constexpr std::size_t kAttributesOfElement = 3'000;  // libxml2 compares each two of them
inline constexpr std::size_t kNameSpaces = 1'000;           // at one place
inline constexpr std::size_t kDeclarations = 1'000;         // of entities and attributes
inline constexpr std::size_t kTagBytes = 9'000'000;         // libxml2 reads 10 MB of an attribute
}  // namespace svg_limits

/// Elements and attributes alone, without texts. Nothing is loaded, over the network or
/// from files. `bytes` may be packed with gzip. Throws InputError, naming `path`, what was found and what is allowed.
SvgTree svg_tree(std::span<const std::uint8_t> bytes, const std::string& path);

}  // namespace tessera
