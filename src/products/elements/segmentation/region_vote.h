// Combines many segmentations of one picture: keeps the regions that most of them agree on.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// `maps`: all of one size. A region's votes are the other maps that have about the same region. Regions are taken in
/// order: solid ones with many votes, a usual size and a strong border (`boundary`: boundary_map()) come first. Later
/// regions must not overlap earlier ones. `element_px`: side of a usual element.
cv::Mat voted_regions(const std::vector<LabelRuns>& maps, const cv::Mat& boundary, double element_px);

}  // namespace tessera
