// A continuous map of a part of the plane, linear on each triangle of a regular grid. It deforms a piece's drawing
// together with its outline (paper, section 5, "Deformation").
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/grid.h"
#include "core/geometry/polygon.h"
#include "core/geometry/vec2.h"

namespace tessera {

/// Three nodes of a warp's grid and their weights at a point.
struct WarpWeights {
  std::array<int, 3> x{};  // columns of the nodes
  std::array<int, 3> y{};  // rows
  std::array<float, 3> weight{};
};

/// Node (i, j) lies at origin + step (i, j). An inactive cell contains no part of what is deformed, and its nodes have
/// no meaning of their own.
struct Warp {
  Vec2 origin;
  float step = 1;
  Grid<Vec2> displacement;    // of the nodes, in the unit of the frame
  Grid<std::uint8_t> active;  // of the cells: one column and one row fewer than the nodes
  bool falling = true;        // cells are divided from their corner (0, 0) to (1, 1); false: from (1, 0) to (0, 1)

  Vec2 node(int i, int j) const { return origin + Vec2{step * float(i), step * float(j)}; }
  Vec2 warped_node(int i, int j) const { return node(i, j) + displacement(i, j); }

  /// The nodes of the triangle that contains p. Points beyond the grid use its nearest point.
  WarpWeights weights_at(Vec2 p) const;
  /// The image of p. Points beyond the grid move as its nearest point.
  Vec2 apply(Vec2 p) const;
  /// The smallest ratio of area after to area before among all triangles of active cells; 1 without such cells. Above 0
  /// the warp has no folds.
  float least_jacobian() const;
};

/// The warp on a larger grid that covers [low, high] and has only active cells. Beyond the warp's own cells it
/// continues as their nearest ones.
Warp spread(const Warp& warp, Vec2 low, Vec2 high);

/// The outline after the map.
Outline warped_outline(Outline outline, const Warp& warp);

/// Converts the map to the frame in which p lies at p * scale + offset; if `mirrored`, x is negated first.
Warp in_frame(const Warp& warp, float scale, Vec2 offset, bool mirrored);

}  // namespace tessera
