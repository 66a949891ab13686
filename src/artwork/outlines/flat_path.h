// A path as polygons and lines.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "artwork/svg/path_steps.h"

namespace tessera {

struct FlatSubpath {
  std::vector<cv::Point2d> points;  // the first one is not repeated at the end
  bool closed = false;              // by its Z, or as it ends where it begins
  std::size_t first_step = 0;       // of the path, and how many are its
  std::size_t steps = 0;
};

/// Nowhere farther than `tolerance` from its curves. Ends that are `tolerance` / 10 apart or less are one point.
std::vector<FlatSubpath> flat_path(const PathSteps& path, double tolerance);

}  // namespace tessera
