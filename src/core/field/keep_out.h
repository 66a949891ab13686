// Zones of the canvas that pieces keep out of: room for a title or a logo, or letters that are part of the picture.
#pragma once

#include <vector>

#include "core/field/canvas.h"

namespace tessera {

/// A rectangle, with round corners if `corner_px` is positive.
struct KeepOutRectangle {
  Vec2 middle_px;
  Vec2 half_size_px;
  Vec2 across{1, 0};    // unit vector along its width; it turns clockwise with the rectangle
  float corner_px = 0;  // radius; limited to half of the shorter side
};

/// Signed distance, px, from the canvas position to the rectangle, positive outside it.
float distance_px(const KeepOutRectangle& zone, Vec2 canvas_px);

/// The distance, at the nodes of the canvas' distance, to the nearest of the zones and their images. There is at least
/// one zone.
CanvasField distance_to(const std::vector<KeepOutRectangle>& zones, const Canvas& canvas);

/// The distance to the cells in which `coverage` is at least one half; (2 width_px) x (2 height_px) cells cover the
/// canvas. If the canvas repeats, so do the zones; distant images do not count.
CanvasField distance_to(const Grid<float>& coverage, const Canvas& canvas);

/// Takes these zones out of the canvas and its regions, in addition to those that it has. The area becomes that of the
/// rest.
void take_out(const CanvasField& zones, Canvas& canvas);

}  // namespace tessera
