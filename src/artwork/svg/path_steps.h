// Paths as cairo writes them into SVGs: from point to point, lines and cubic Bézier curves, all coordinates absolute.
#pragma once

#include <cairo.h>

#include <array>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tessera {

struct PathStep {
  char command;                            // M, L, C or Z
  std::array<cv::Point2d, 3> points = {};  // one; of C the two control points and the end; of Z none
};
using PathSteps = std::vector<PathStep>;

int points_of(const PathStep& step);

/// Reads the data of a path. Throws InputError where there is another command, or a number is missing or not finite.
PathSteps path_steps(std::string_view data);
PathSteps rectangle_steps(const cv::Rect2d& rectangle);
/// The data of the path, `digits` of each number.
std::string path_data(const PathSteps& steps, int digits);

cv::Point2d transformed(const cairo_matrix_t& matrix, cv::Point2d p);
PathSteps transformed(const cairo_matrix_t& matrix, PathSteps steps);

/// Around all points, control points as well; empty without any.
cv::Rect2d box_of(const PathSteps& steps);
/// Where the path is a rectangle with level sides.
std::optional<cv::Rect2d> level_rectangle(const PathSteps& steps);

}  // namespace tessera
