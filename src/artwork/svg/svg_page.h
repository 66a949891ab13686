// Draws SVG and SVGZ with librsvg and cairo.
//
// Protection against hostile files:
// - The file is parsed from memory without a base address: librsvg then refuses every reference (image, use, feImage,
// xi:include, stylesheet) to a file or to the network; data: images work.
// - It has at most kMaxSvgBytes after decompression; libxml2 limits entity expansion and depth.
// - librsvg stops at 1,000,000 elements and 500,000 resolved references.
// These functions do not limit the time and memory of drawing (filters, nested masks, huge embedded images). librsvg
// cannot be interrupted, and 2.54 even aborts the process for an feConvolveMatrix whose matrix has the wrong size.
// Therefore tessera-drawer draws foreign files, in processes with limits (drawers.h).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "artwork/images/artwork_page.h"

namespace tessera {

/// CSS px in an inch.
inline constexpr double kCssPxPerInch = 96;

inline constexpr std::size_t kMaxSvgBytes = 64u << 20;

/// Opens an SVG. Throws InputError where it is no SVG, is damaged or exceeds a limit.
std::unique_ptr<ArtworkPage> open_svg_page(std::span<const std::uint8_t> bytes, const std::string& path);

}  // namespace tessera
