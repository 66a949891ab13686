// Zones of the canvas that pieces keep out of: room for a title or a logo, or letters that are part of the picture.
#pragma once

#include <vector>

#include "core/field/canvas.h"

namespace tessera {

/// With round corners where `corner_px` says so.
struct KeepOutRectangle {
  Vec2 middle_px;
  Vec2 half_size_px;
  Vec2 across{1, 0};    // unit, along its width: turned clockwise with the rectangle
  float corner_px = 0;  // radius; more than half of the shorter side is as good as that
};

/// Signed distance, px, from the canvas position to the rectangle, positive outside it.
float distance_px(const KeepOutRectangle& zone, Vec2 canvas_px);

/// At the nodes of the canvas' distance: that to the nearest of the zones and their images. At least one zone.
CanvasField distance_to(const std::vector<KeepOutRectangle>& zones, const Canvas& canvas);

/// The same to what `coverage` marks with a half or more: (2 width_px) x (2 height_px) cells over the canvas. Where the
/// canvas repeats the zones do, and images that are further away than fields look do not count.
CanvasField distance_to(const Grid<float>& coverage, const Canvas& canvas);

/// Takes these zones, besides those that it has, out of the canvas and of its regions. The area is that of what is
/// left.
void take_out(const CanvasField& zones, Canvas& canvas);

}  // namespace tessera
