// Combines many segmentations of one picture: keeps the regions that most of them agree on.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

struct VotedRegions {
  cv::Mat labels;
  /// The area of the regions, each by its solidity and by the part of the other maps that agree with it.
  double support_px2 = 0;
};

/// `maps`: all of one size. A region's votes are the other maps that have about the same region. Regions are taken in
/// order: solid ones with many votes, a usual size and a strong border (`boundary`: boundary_map()) come first. Later
/// regions must not overlap earlier ones. `element_px`: side of a usual element.
VotedRegions voted_regions(const std::vector<LabelRuns>& maps, const cv::Mat& boundary, double element_px);

}  // namespace tessera
