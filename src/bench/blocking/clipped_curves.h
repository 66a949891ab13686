// The protocol of the paper's Figs. 26 and 27: what is seen of a silhouette whose left part is hidden.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "bench/blocking/seen_curves.h"

namespace tessera::bench {

struct Clipping {
  double blocked = 0;        // part of the bounding box's width that is hidden, from the left
  bool edge_removed = true;  // the clip edge is cut out of the curves, which are open then; else it counts as boundary
};

/// The query that is left of the mask (seen_curves()).
std::vector<Curve> clipped_curves(const cv::Mat& mask, const Clipping& clipping, const View& view, Draws& draws);

}  // namespace tessera::bench
