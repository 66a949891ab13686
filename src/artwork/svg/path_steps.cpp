#include "artwork/svg/path_steps.h"

#include <algorithm>

#include "artwork/svg/svg_values.h"
#include "core/base/error.h"
#include "text/number_text.h"

namespace tessera {
namespace {

int points_of_command(char command) {
  switch (command) {
    case 'M':
    case 'L': return 1;
    case 'C': return 3;
    case 'Z': return 0;
  }
  throw InputError(std::string("a path's command: found \"") + command + "\", allowed: M, L, C and Z");
}

/// Removes each M without a following step: it draws nothing.
void remove_idle_moves(PathSteps& steps) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool is_idle = steps[i].command == 'M' && (i + 1 == steps.size() || steps[i + 1].command == 'M');
    if (!is_idle) steps[kept++] = steps[i];
  }
  steps.resize(kept);
}

}  // namespace

int points_of(const PathStep& step) { return points_of_command(step.command); }

PathSteps path_steps(std::string_view data) {
  PathSteps steps;
  NumberReader reader(data);
  while (const char command = reader.next_letter()) {
    PathStep step{.command = command};
    for (int k = 0; k < points_of_command(command); ++k) {
      const double x = reader.next_number();
      step.points[std::size_t(k)] = {x, reader.next_number()};
    }
    if (steps.empty() && command != 'M') throw InputError("a path that does not begin with M");
    steps.push_back(step);
  }
  remove_idle_moves(steps);
  return steps;
}

PathSteps rectangle_steps(const cv::Rect2d& r) {
  return {{'M', {{{r.x, r.y}}}},
          {'L', {{{r.x + r.width, r.y}}}},
          {'L', {{{r.x + r.width, r.y + r.height}}}},
          {'L', {{{r.x, r.y + r.height}}}},
          {'Z'}};
}

std::string path_data(const PathSteps& steps, int digits) {
  std::string data;
  for (const PathStep& step : steps) {
    data += step.command;
    for (int k = 0; k < points_of(step); ++k) {
      const cv::Point2d p = step.points[std::size_t(k)];
      if (k > 0) data += ' ';
      data += significant(p.x, digits) + ' ' + significant(p.y, digits);
    }
  }
  return data;
}

cv::Point2d transformed(const cairo_matrix_t& matrix, cv::Point2d p) {
  cairo_matrix_transform_point(&matrix, &p.x, &p.y);
  return p;
}

PathSteps transformed(const cairo_matrix_t& matrix, PathSteps steps) {
  for (PathStep& step : steps) {
    for (cv::Point2d& p : step.points) p = transformed(matrix, p);
  }
  return steps;
}

cv::Rect2d box_of(const PathSteps& steps) {
  if (steps.empty()) return {};
  cv::Point2d low = steps.front().points[0], high = low;
  for (const PathStep& step : steps) {
    for (int k = 0; k < points_of(step); ++k) {
      const cv::Point2d p = step.points[std::size_t(k)];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  return {low, high};
}

std::optional<cv::Rect2d> level_rectangle(const PathSteps& steps) {
  if (steps.size() != 5 || steps[0].command != 'M' || steps[4].command != 'Z') return std::nullopt;
  for (std::size_t i = 0; i < 4; ++i) {
    const cv::Point2d a = steps[i].points[0], b = steps[(i + 1) % 4].points[0];
    const bool is_level = i % 2 == (a.y == b.y ? 0 : 1) && (a.x == b.x) != (a.y == b.y);
    if ((i > 0 && steps[i].command != 'L') || !is_level) return std::nullopt;
  }
  return box_of(steps);
}

}  // namespace tessera
