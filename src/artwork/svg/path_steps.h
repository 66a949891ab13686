// Paths as cairo writes them into SVGs: lines and cubic Bézier curves from point to point, all coordinates absolute.
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
  std::array<cv::Point2d, 3> points = {};  // one point; for C two control points and the end; for Z none
};
using PathSteps = std::vector<PathStep>;

int points_of(const PathStep& step);

/// Reads the data of a path. Throws InputError where there is another command, or a number is missing or not finite.
PathSteps path_steps(std::string_view data);
PathSteps rectangle_steps(const cv::Rect2d& rectangle);
/// The data of the path, with `digits` for each number.
std::string path_data(const PathSteps& steps, int digits);

cv::Point2d transformed(const cairo_matrix_t& matrix, cv::Point2d p);
PathSteps transformed(const cairo_matrix_t& matrix, PathSteps steps);

/// The box round all points, control points included; empty without any.
cv::Rect2d box_of(const PathSteps& steps);
/// The rectangle, if the path is one with horizontal and vertical sides.
std::optional<cv::Rect2d> level_rectangle(const PathSteps& steps);

}  // namespace tessera
