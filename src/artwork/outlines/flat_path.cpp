#include "artwork/outlines/flat_path.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

/// Adds the points of a cubic Bézier curve, without its first one.
void add_cubic(cv::Point2d a, const std::array<cv::Point2d, 3>& curve, double tolerance,
               std::vector<cv::Point2d>& points) {
  constexpr double kMostSteps = 500;
  const auto [b, c, d] = curve;
  // The second difference bounds the distance between a step's chord and the curve.
  const double bend = std::max(cv::norm(a - 2 * b + c), cv::norm(b - 2 * c + d));
  const int steps = int(std::clamp(std::ceil(std::sqrt(0.75 * bend / tolerance)), 1.0, kMostSteps));
  for (int i = 1; i < steps; ++i) {
    const double t = double(i) / steps, s = 1 - t;
    points.push_back(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
  }
  points.push_back(d);
}

}  // namespace

std::vector<FlatSubpath> flat_path(const PathSteps& path, double tolerance) {
  std::vector<FlatSubpath> subpaths;
  const auto begin = [&](cv::Point2d p, std::size_t step) { subpaths.push_back({.points = {p}, .first_step = step}); };
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PathStep& step = path[i];
    if (step.command == 'M') {
      begin(step.points[0], i);
    } else if (subpaths.back().closed) {  // continues where the closed one began
      const cv::Point2d from = subpaths.back().points.front();
      begin(from, i);
    }
    FlatSubpath& subpath = subpaths.back();
    ++subpath.steps;
    if (step.command == 'L') subpath.points.push_back(step.points[0]);
    if (step.command == 'C') {
      const cv::Point2d from = subpath.points.back();
      add_cubic(from, step.points, tolerance, subpath.points);
    }
    if (step.command == 'Z') subpath.closed = true;
  }
  for (FlatSubpath& subpath : subpaths) {
    std::vector<cv::Point2d>& points = subpath.points;
    while (points.size() > 1 && cv::norm(points.back() - points.front()) < tolerance / 10) {
      points.pop_back();
      subpath.closed = true;
    }
  }
  return subpaths;
}

}  // namespace tessera
