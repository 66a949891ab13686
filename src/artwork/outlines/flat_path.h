// A path as polygons and lines.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "artwork/svg/path_steps.h"

namespace tessera {

struct FlatSubpath {
  std::vector<cv::Point2d> points;  // the first one is not repeated at the end
  bool closed = false;              // by its Z, or as it ends where it begins
  std::size_t first_step = 0;       // the first of the path's steps that are its
  std::size_t steps = 0;            // how many are its
};

/// The path's subpaths as points that are nowhere farther than `tolerance` from its curves (of which each has 500 points
/// at most). Where the ends of a subpath are less than `tolerance` / 10 apart, they are one point.
std::vector<FlatSubpath> flat_path(const PathSteps& path, double tolerance);

}  // namespace tessera
