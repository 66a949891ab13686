// Curves of a foreign drawing: outlines of what it shows, or the centre lines of its strokes.
#pragma once

#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "core/recognition/curve.h"

namespace tessera {

struct DrawnCurves {
  std::vector<Curve> curves;  // at least one, in the drawing's units: px of an image, 1/96 inch of an SVG; y down
  float pixel = 1;            // side of a pixel, in these units, of what the curves were traced in
};

enum class TracedAs { outlines, centre_lines };

/// Curves of an SVG, an image or a mask. It is drawn by `drawers`, and traced in pixels: one way for all formats.
/// outlines: all contours of its silhouette, holes too, with the interior on the left. centre_lines: what is drawn is
/// thinned to lines one pixel wide, which are cut where they meet (line_trace.h).
/// Throws InputError, which names the file, where it is no artwork, shows nothing, or lies beyond what a curve may.
DrawnCurves read_drawn_curves(const std::string& path, TracedAs kind, Drawers& drawers);

}  // namespace tessera
