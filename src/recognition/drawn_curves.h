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

/// Reads the curves of an SVG, an image or a mask. `drawers` draw it and it is traced in pixels, in the same way for all
/// formats. outlines: all contours of its silhouette with holes, with the interior on the left. centre_lines: the drawing
/// is thinned to lines one pixel wide, which are cut where they meet (line_trace.h). Throws InputError that names the file
/// where it is no artwork, shows nothing, or exceeds the limits of a curve.
DrawnCurves read_drawn_curves(const std::string& path, TracedAs kind, Drawers& drawers);

}  // namespace tessera
