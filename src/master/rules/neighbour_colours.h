// Neighbours of like or unlike colours: what a candidate's colour is worth beside the pieces that stand round it.
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
  /// `period` is that of the canvas: across a seam pieces are neighbours, too.
  NeighbourColours(const ColourWish& wish, const Period& period);

  /// A piece of this placement stands from now on.
  void add(const Placement& placement);
  void forget_placements();

  /// 1 to 0, by the neighbour whose colour is the least welcome: it falls as pieces are placed, and does not depend on
  /// their order. 1 where neighbours do not matter.
  float worth(ShapeId shape, const Similarity& canvas_from_shape) const;

 private:
  bool matters() const { return wish_.neighbours != 0; }
  const Lab& colour_of(ShapeId shape) const { return (*wish_.of_shapes)[index_of(shape)].mean; }

  ColourWish wish_;
  Period period_;
  std::vector<Placement> placed_;
  TileIndex index_;  // of placed_, by the squares in which their neighbours' begin, canvas px
};

}  // namespace tessera::master
