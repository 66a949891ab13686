// The test of the paper's Figs. 26 and 27: the visible curves of a silhouette whose left part is hidden.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "bench/blocking/seen_curves.h"

namespace tessera::bench {

struct Clipping {
  double blocked = 0;        // hidden part of the bounding box's width, from the left
  bool edge_removed = true;  // true: curves are open at the clip edge; false: the clip edge counts as boundary
};

/// The query from the visible part of the mask (see seen_curves()).
std::vector<Curve> clipped_curves(const cv::Mat& mask, const Clipping& clipping, const View& view, Draws& draws);

}  // namespace tessera::bench
