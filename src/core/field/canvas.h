// What is to be filled. Canvas frame: px, y down, origin at the upper left corner of the upper left pixel.
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

/// A part of the canvas that is filled for itself.
struct CanvasRegion {
  CanvasField distance;
  double area_px2 = 0;
};

/// The region to fill, with holes. `distance` is the signed distance to its boundary in px, positive inside, on nodes
/// at the pixel centres and on a rim of kCanvasMargin nodes around the canvas (negative there). It is a true distance
/// everywhere: who looks for pieces beyond the edge steps by it.
struct Canvas {
  int width_px = 0;
  int height_px = 0;
  CanvasField distance;
  std::vector<CanvasRegion> regions = {};  // where there are several; in the order of filling
  double area_px2 = 0;
  /// Of zones that were taken out of it (keep_out.h): the distance to them, positive outside. Empty: there are none.
  CanvasField keep_out = {};
  Period period;  // where it repeats: as wide and high as the canvas, without an edge there

  bool has_zones() const { return !keep_out.value.data().empty(); }
};

inline constexpr int kCanvasMargin = 6;
/// The distance to an edge that is not there.
inline constexpr float kNoEdge_px = 1e5f;

Canvas make_rectangle_canvas(int width_px, int height_px);

/// One period of a plane that is to be filled without a seam from left to right, from top to bottom, or both.
Canvas make_seamless_canvas(int width_px, int height_px, bool in_x, bool in_y);

/// `coverage` is the fraction (0..1) of each cell that belongs to the region, `cells_per_px` of them to a canvas px
/// both ways: 2, with which the edge is true to a quarter of a px, or 1, to half a px, where memory counts.
Canvas make_mask_canvas(const Grid<float>& coverage, int cells_per_px = 2);

/// Of the positive part of a signed distance at a canvas' nodes, by how much of each px lies inside.
double area_px2(const CanvasField& distance, int width_px, int height_px);

}  // namespace tessera
