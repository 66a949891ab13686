// The protocol of the paper's Figs. 26 and 27: what is seen of a silhouette whose left part is hidden.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/geometry/grid.h"
#include "core/recognition/curve.h"
#include "core/replacing/draws.h"

namespace tessera::bench {

/// How a query is made of a silhouette, in this order.
struct Clipping {
  double blocked = 0;        // part of the bounding box's width that is hidden, from the left
  double turned_rad = 0;     // about the middle of what is left
  double size = 1;           // px of the query for one px of the mask
  double noise_px = 0;       // standard deviation across the boundary, at points 1 px apart, query px
  bool edge_removed = true;  // the clip edge is cut out of the curves, which are open then; else it counts as boundary
};

/// The boundary of what is left of the mask, query px, interior on the left. No curve where nothing is left that is larger
/// than a few pixels. `draws` gives the noise.
std::vector<Curve> clipped_curves(const cv::Mat& mask, const Clipping& clipping, Draws& draws);

/// The values of a mask as the tracing of outlines takes them, 0 to 1.
Grid<float> coverage_of(const cv::Mat& mask);

}  // namespace tessera::bench
