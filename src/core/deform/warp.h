// A continuous map of a part of the plane, linear on each triangle of a regular grid: how a piece's drawing is deformed
// together with its outline (paper, section 5, "Deformation").
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/grid.h"
#include "core/geometry/polygon.h"
#include "core/geometry/vec2.h"

namespace tessera {

/// Three nodes of a warp's grid and how much each of them counts at a point.
struct WarpWeights {
  std::array<int, 3> x{};  // columns of the nodes
  std::array<int, 3> y{};  // rows
  std::array<float, 3> weight{};
};

/// Node (i, j) lies at origin + step (i, j). A cell that is not active says nothing of its own: no part of what is deformed
/// lies in it.
struct Warp {
  Vec2 origin;
  float step = 1;
  Grid<Vec2> displacement;    // of the nodes, in the same unit
  Grid<std::uint8_t> active;  // of the cells: one column and one row less than the nodes
  bool falling = true;        // a cell is divided from its corner (0, 0) to (1, 1); else from (1, 0) to (0, 1)

  Vec2 node(int i, int j) const { return origin + Vec2{step * float(i), step * float(j)}; }
  Vec2 warped_node(int i, int j) const { return node(i, j) + displacement(i, j); }

  /// The nodes of the triangle that holds p, or of that at the grid's nearest point.
  WarpWeights weights_at(Vec2 p) const;
  /// Where p comes to lie. Beyond the grid everything moves as its nearest point.
  Vec2 apply(Vec2 p) const;
  /// Of all triangles of active cells the smallest ratio of the area after to that before; 1 without such cells. Where it
  /// is above 0, nothing is folded.
  float least_jacobian() const;
};

/// The warp on a grid whose cells are all active and that covers what lies from `low` to `high`: it goes on beyond its own
/// cells as their nearest ones do.
Warp spread(const Warp& warp, Vec2 low, Vec2 high);

/// Curves after the map.
Outline warped_outline(Outline outline, const Warp& warp);

/// The same map in the frame in which p lies at p * scale + offset, its x reversed before where `mirrored`.
Warp in_frame(const Warp& warp, float scale, Vec2 offset, bool mirrored);

}  // namespace tessera
