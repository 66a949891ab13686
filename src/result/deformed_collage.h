// A collage with deformed pieces: each piece has its own shape, and its drawing is the warped drawing of a library's shape.
#pragma once

#include <cstddef>
#include <vector>

#include "core/deform/warp.h"
#include "core/shape/shape_id.h"
#include "result/placed_shapes.h"

namespace tessera {

/// The gains and costs of deforming, for the card.
struct DeformationFigures {
  double coverage_before = 0;
  double overlap_before = 0;
  std::size_t pieces = 0;          // number of deformed pieces
  double median_pad_distance = 0;  // PAD distance to the shape before (core/deform/identity.h)
  double largest_pad_distance = 0;
  double median_area_change = 0;  // relative change, up or down
  double largest_area_change = 0;
  double farthest_px = 0;     // largest movement of a boundary point
  double least_jacobian = 1;  // of all warps; above 0: no drawing is folded
  double seconds = 0;
};

struct DeformedCollage {
  PlacedShapes originals;        // the shapes that were placed
  std::vector<ShapeId> shapes;   // of the pieces: their shape in the library, also in `originals`
  std::vector<Warp> warps;       // of the pieces, in the shape frame
  std::vector<float> margin_px;  // of the pieces: how much larger their page is on every side, artwork px
  DeformationFigures figures;
};

}  // namespace tessera
