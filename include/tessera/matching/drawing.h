/// @file
/// Outlines of drawings: SVGs, images (PNG, JPEG, WebP, TIFF, BMP) and masks.
#pragma once

#include <string>

#include "tessera/matching/export.h"
#include "tessera/matching/outline.h"

namespace tessera::matching {

/// The lines of a drawing that become curves.
enum class Trace {
  outlines,     ///< the outlines of its silhouette, holes too: closed curves
  centre_lines  ///< the middles of its strokes, which are cut where they meet: open curves, as a rule
};

/// The curves of a drawing, in px of an image or 1/96 inch of an SVG, y down, with the smoothing that its pixels need. They
/// are traced on a page of 1024 px. Where there are more than 200 curves, only the longest are kept.
///
/// The program tessera-drawer reads the file, in a process with limits on memory and time, so that a hostile file can do no
/// harm. It is installed with the library, in ../libexec/tessera seen from the library's folder. The environment variable
/// TESSERA_DRAWER names another place.
///
/// Throws Error that names the file where it cannot be read or shows nothing, and where there is no tessera-drawer.
TESSERA_MATCHING_API Outline read_drawing(const std::string& path, Trace trace = Trace::outlines);

}  // namespace tessera::matching
