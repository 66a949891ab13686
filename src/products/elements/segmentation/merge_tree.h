// Elements as the best cut through a tree of merges: regions whose common border is weak become one, step by step, and
// of all regions on the way those are kept that look most like elements.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// `boundary`: boundary_map(), smoothed. `leaves`: CV_32S, 1..n, everywhere. `solidity_power`: how much roundish
/// regions are preferred. Labels CV_32S, 0 where nothing looks like an element.
cv::Mat best_of_merge_tree(const cv::Mat& boundary, const cv::Mat& leaves, double solidity_power);

}  // namespace tessera
