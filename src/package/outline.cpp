#include "tessera/matching/outline.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "package/number_in_message.h"
#include "package/outline_box.h"
#include "tessera/matching/error.h"

namespace tessera::matching {
namespace {

constexpr double kFarthest = 1e15;
/// Limits: a curve's length as a part of the bounding box of all curves; that box as a part of its distance from the
/// origin; and the box itself.
constexpr double kShortestCurve = 1e-6;
constexpr double kSmallestBox = 1e-11;
constexpr double kSmallestExtent = 1e-100;
/// The smoothing as a part of the length: with wider smoothing no curve keeps its shape.
constexpr double kWidestSmoothing = 1.0 / 24;

std::string points_text(std::size_t count) { return std::to_string(count) + (count == 1 ? " point" : " points"); }

double length_of(const Curve& curve) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    length += std::hypot(curve.points[i + 1].x - curve.points[i].x, curve.points[i + 1].y - curve.points[i].y);
  }
  if (!curve.closed || curve.points.empty()) return length;
  return length +
         std::hypot(curve.points.front().x - curve.points.back().x, curve.points.front().y - curve.points.back().y);
}

/// The shoelace area, relative to the first point: far from the origin products of coordinates lose their decimals.
double signed_area(const std::vector<Point>& polygon) {
  if (polygon.empty()) return 0;
  const Point origin = polygon.front();
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point p = polygon[i];
    const Point q = polygon[(i + 1) % polygon.size()];
    twice += (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
  }
  return twice / 2;
}

/// Whether the point lies in the polygon, by the even-odd rule.
bool contains(const std::vector<Point>& polygon, Point p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

void check_points(const Curve& curve, const std::string& name) {
  const std::size_t least = curve.closed ? 3 : 2;
  if (curve.points.size() < least) {
    throw Error(name + ": found " + points_text(curve.points.size()) + ", allowed: " + points_text(least) +
                " or more of " + (curve.closed ? "a closed" : "an open") + " curve");
  }
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    for (const double coordinate : {curve.points[i].x, curve.points[i].y}) {
      if (std::abs(coordinate) <= kFarthest) continue;
      throw Error(name + ": point " + std::to_string(i) + ": found the coordinate " + number_in_message(coordinate) +
                  ", allowed: -1e15 to 1e15");
    }
  }
}

void check_counts(const Outline& outline) {
  if (outline.curves.empty()) throw Error("an outline without curves; allowed: 1 or more");
  if (outline.curves.size() > kMostCurves) {
    throw Error("an outline of " + std::to_string(outline.curves.size()) +
                " curves, allowed: " + std::to_string(kMostCurves) + " or fewer");
  }
  std::size_t points = 0;
  for (const Curve& curve : outline.curves) points += curve.points.size();
  if (points > kMostPoints) {
    throw Error("an outline of " + std::to_string(points) + " points, allowed: " + std::to_string(kMostPoints) +
                " or fewer");
  }
}

double farthest(const OutlineBox& box) {
  return std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
}

}  // namespace

void check(const Outline& outline) {
  check_counts(outline);
  for (std::size_t c = 0; c < outline.curves.size(); ++c) {
    check_points(outline.curves[c], "curve " + std::to_string(c));
  }
  const OutlineBox box = box_of(outline);
  if (!(box.extent() > std::max(kSmallestExtent, kSmallestBox * farthest(box)))) {
    throw Error("an outline whose points are all equal, or too close together for their distance from the origin");
  }
  double total = 0;
  for (std::size_t c = 0; c < outline.curves.size(); ++c) {
    const double length = length_of(outline.curves[c]);
    if (!(length > kShortestCurve * box.extent())) {
      throw Error("curve " + std::to_string(c) + ": found a length of " + number_in_message(length) +
                  ", allowed: more than a millionth of the whole outline's size of " + number_in_message(box.extent()));
    }
    total += length;
  }
  if (!(outline.smoothing >= 0 && outline.smoothing <= kWidestSmoothing * total)) {
    throw Error("smoothing: found " + number_in_message(outline.smoothing) + ", allowed: 0 to " +
                number_in_message(kWidestSmoothing * total) + ", a 24th of the length of all curves");
  }
}

Outline make_outline(std::vector<std::vector<Point>> polygons) {
  Outline outline;
  for (std::vector<Point>& polygon : polygons) outline.curves.push_back({std::move(polygon), true});
  check(outline);
  std::vector<OutlineBox> boxes(outline.curves.size());
  for (std::size_t c = 0; c < boxes.size(); ++c) boxes[c].add(outline.curves[c]);
  std::vector<bool> is_hole(boxes.size());
  for (std::size_t c = 0; c < boxes.size(); ++c) {
    const Point p = outline.curves[c].points.front();
    for (std::size_t other = 0; other < boxes.size(); ++other) {
      if (other == c || !boxes[other].contains(p)) continue;
      if (contains(outline.curves[other].points, p)) is_hole[c] = !is_hole[c];
    }
  }
  for (std::size_t c = 0; c < boxes.size(); ++c) {
    std::vector<Point>& points = outline.curves[c].points;
    if ((signed_area(points) < 0) != is_hole[c]) std::reverse(points.begin(), points.end());
  }
  return outline;
}

double length_of(const Outline& outline) {
  check(outline);
  double length = 0;
  for (const Curve& curve : outline.curves) length += length_of(curve);
  return length;
}

double area_of(const Outline& outline) {
  check(outline);
  double area = 0;
  for (const Curve& curve : outline.curves) {
    if (curve.closed) area += signed_area(curve.points);
  }
  return area;
}

}  // namespace tessera::matching
