// The joints between neighbours on a map of elements.
#pragma once

#include <opencv2/core.hpp>
#include <utility>
#include <vector>

namespace tessera {

/// A place where the regions nearest to two elements meet.
struct JointPlace {
  int first = 0, second = 0;  // labels, first < second
  cv::Vec2f across;           // from the first to the second, of length 1
  float width_px = 0;         // 0: they touch
};

/// The places of all joints up to this width, sorted by `first` and `second`. `labels`: CV_32S, 0 between elements.
std::vector<JointPlace> joint_places(const cv::Mat& labels, float most_px);

}  // namespace tessera
