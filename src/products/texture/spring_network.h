// Springs between points of a plane.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// The second point feels the force -(stiffness * (its way - the way of the first) + pull), and the first one the opposite.
struct Spring {
  std::size_t first = 0, second = 0;
  cv::Matx22d stiffness = cv::Matx22d::zeros();  // symmetric, positive semidefinite
  cv::Vec2d pull;
};

/// The ways that points go until all forces are nearly zero. `moved`: how far each lies from its place, where it is held
/// weakly.
std::vector<cv::Vec2d> ways_at_rest(const std::vector<Spring>& springs, const std::vector<cv::Vec2d>& moved);

}  // namespace tessera
