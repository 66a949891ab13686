// Many segmentations of one picture, and what most of them agree on.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// `maps`: of one size. A region's votes are the other maps that have about the same region; regions that
/// are solid, well voted for, of a usual size and with a strong border (`boundary`: boundary_map()) come first, and
/// each keeps off those before it. `element_px`: side of a usual element.
cv::Mat voted_regions(const std::vector<LabelRuns>& maps, const cv::Mat& boundary, double element_px);

}  // namespace tessera
