// The canvas: the region to fill. Canvas frame: px, y down, origin at the upper left corner of the upper left pixel.
#pragma once

#include <vector>

#include "core/geometry/grid.h"
#include "core/geometry/period.h"
#include "core/geometry/vec2.h"

namespace tessera {

/// A scalar field over the canvas; node (i, j) lies at canvas position origin + (i, j).
struct CanvasField {
  Grid<float> value;
  Vec2 origin;
};

/// A part of the canvas that is filled separately.
struct CanvasRegion {
  CanvasField distance;
  double area_px2 = 0;
};

/// The region to fill, with holes. `distance` is the signed distance to its boundary in px, positive inside. Its nodes
/// are the pixel centres and a rim of kCanvasMargin nodes around the canvas, where the distance is negative. It is a
/// true distance everywhere, as searches for pieces beyond the edge use it as step.
struct Canvas {
  int width_px = 0;
  int height_px = 0;
  CanvasField distance;
  std::vector<CanvasRegion> regions = {};  // empty if there is only one region; in the order of filling
  double area_px2 = 0;
  /// The distance to the zones that were taken out of the region (keep_out.h), positive outside. Empty: there are none.
  CanvasField keep_out = {};
  Period period;  // in a direction that repeats: the canvas' width or height, and no edge there

  bool has_zones() const { return !keep_out.value.data().empty(); }
};

inline constexpr int kCanvasMargin = 6;
/// The distance to an edge that does not exist.
inline constexpr float kNoEdge_px = 1e5f;

Canvas make_rectangle_canvas(int width_px, int height_px);

/// One period of a plane that is filled without a seam from left to right (`in_x`), from top to bottom (`in_y`), or
/// both.
Canvas make_seamless_canvas(int width_px, int height_px, bool in_x, bool in_y);

/// `coverage` is the fraction (0..1) of each cell that belongs to the region, with `cells_per_px` cells per px in each
/// direction. With 2 the edge is exact to a quarter of a px; 1, exact to half a px, saves memory.
Canvas make_mask_canvas(const Grid<float>& coverage, int cells_per_px = 2);

/// The area where a signed distance at a canvas' nodes is positive; pixels at the boundary count in part.
double area_px2(const CanvasField& distance, int width_px, int height_px);

}  // namespace tessera
