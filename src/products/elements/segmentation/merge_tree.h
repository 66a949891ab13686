// Finds elements by a tree of merges: step by step, regions with a weak common border become one. From all regions in the
// tree it keeps those that look most like elements.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// `boundary`: boundary_map(), smoothed. `leaves`: CV_32S, 1..n, without gaps. `solidity_power`: how strongly roundish
/// regions are preferred. Returns labels, CV_32S, 0 where nothing looks like an element.
cv::Mat best_of_merge_tree(const cv::Mat& boundary, const cv::Mat& leaves, double solidity_power);

}  // namespace tessera
