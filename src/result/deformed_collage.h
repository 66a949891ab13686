// A collage whose pieces were deformed: each has a shape of its own, and its drawing is that of a library's shape, warped.
#pragma once

#include <cstddef>
#include <vector>

#include "core/deform/warp.h"
#include "core/shape/shape_id.h"
#include "result/placed_shapes.h"

namespace tessera {

/// What deforming brought, for the card.
struct DeformationFigures {
  double coverage_before = 0;
  double overlap_before = 0;
  std::size_t pieces = 0;          // that were deformed
  double median_pad_distance = 0;  // to what they were (core/deform/identity.h)
  double largest_pad_distance = 0;
  double median_area_change = 0;  // of it, up or down
  double largest_area_change = 0;
  double farthest_px = 0;     // that a boundary moved
  double least_jacobian = 1;  // of all warps: above 0, no drawing is folded
  double seconds = 0;
};

struct DeformedCollage {
  PlacedShapes originals;        // that were placed
  std::vector<ShapeId> shapes;   // of the pieces: in the library, and here in `originals`
  std::vector<Warp> warps;       // of the pieces, shape frame
  std::vector<float> margin_px;  // of the pieces: their page is so much larger on every side, artwork px
  DeformationFigures figures;
};

}  // namespace tessera
