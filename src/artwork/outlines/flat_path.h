// A path as polygons and lines.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "artwork/svg/path_steps.h"

namespace tessera {

struct FlatSubpath {
  std::vector<cv::Point2d> points;  // the first one is not repeated at the end
  bool closed = false;              // by its Z, or because it ends where it begins
  std::size_t first_step = 0;       // its first step in the path
  std::size_t steps = 0;            // number of its steps
};

/// The path's subpaths as points that are at most `tolerance` away from its curves (at most 500 points for each curve).
/// Ends of a subpath that are less than `tolerance` / 10 apart become one point.
std::vector<FlatSubpath> flat_path(const PathSteps& path, double tolerance);

}  // namespace tessera
