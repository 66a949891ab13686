// Neighbours of like or unlike colours: what a candidate's colour is worth beside the pieces around it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/collage/placement.h"
#include "core/colour/colour_wish.h"
#include "core/geometry/period.h"
#include "core/geometry/tile_index.h"

namespace tessera::master {

class NeighbourColours {
 public:
  /// `period` is that of the canvas: pieces are neighbours across a seam, too.
  NeighbourColours(const ColourWish& wish, const Period& period);

  /// Adds a piece that stands from now on.
  void add(const Placement& placement);
  void forget_placements();

  /// A factor from 1 to 0, by the neighbour whose colour is the least welcome. It falls as pieces are placed, in any order.
  /// 1 where the job has no wish about neighbours.
  float worth(ShapeId shape, const Similarity& canvas_from_shape) const;

 private:
  bool matters() const { return wish_.neighbours != 0; }
  const Lab& colour_of(ShapeId shape) const { return (*wish_.of_shapes)[index_of(shape)].mean; }

  ColourWish wish_;
  Period period_;
  std::vector<Placement> placed_;
  TileIndex index_;  // of placed_, by squares that overlap for neighbours, canvas px
};

}  // namespace tessera::master
