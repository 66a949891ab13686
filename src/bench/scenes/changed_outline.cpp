#include "bench/scenes/changed_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/blocking/seen_curves.h"
#include "core/geometry/closed_curve.h"
#include "core/geometry/contour.h"
#include "core/geometry/polygon.h"
#include "core/geometry/rasterise.h"
#include "core/geometry/similarity.h"

namespace tessera::bench {
namespace {

constexpr int kPoints = 512;
constexpr int kArcTries = 400;
/// Limits for the new arc: its length relative to the replaced one, and the scale at which its ends fit.
constexpr float kShortest = 0.6f;
constexpr float kLongest = 1.6f;
constexpr float kLeastScale = 0.8f;
constexpr float kMostScale = 1.25f;
/// Some point of the new arc must be at least this far from the old one, relative to the square root of the area.
constexpr float kLeastChange = 0.1f;
constexpr int kFilledMargin_px = 8;

double size_of(const std::vector<Vec2>& outline) { return std::sqrt(std::abs(signed_area(outline))); }

/// The points of an arc of a closed curve from `first` on, both ends included.
std::vector<Vec2> arc_of(const std::vector<Vec2>& closed, std::size_t first, std::size_t steps) {
  std::vector<Vec2> arc;
  for (std::size_t k = 0; k <= steps; ++k) arc.push_back(closed[(first + k) % closed.size()]);
  return arc;
}

float arc_length(const std::vector<Vec2>& arc) {
  float length = 0;
  for (std::size_t i = 1; i < arc.size(); ++i) length += norm(arc[i] - arc[i - 1]);
  return length;
}

/// Maps the arc's ends to the given points.
Similarity onto_ends(const std::vector<Vec2>& arc, Vec2 from, Vec2 to) {
  const Vec2 own = arc.back() - arc.front();
  const Vec2 wanted = to - from;
  const float squared = dot(own, own);
  const float a = dot(own, wanted) / squared;
  const float b = cross(own, wanted) / squared;
  const Vec2 start = arc.front();
  return {a, b, from.x - (a * start.x - b * start.y), from.y - (b * start.x + a * start.y)};
}

bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p) > 0; };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

bool crosses_itself(const std::vector<Vec2>& closed) {
  const std::size_t count = closed.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 2; j < count; ++j) {
      if (i == 0 && j == count - 1) continue;
      if (cross_each_other(closed[i], closed[i + 1], closed[j], closed[(j + 1) % count])) return true;
    }
  }
  return false;
}

/// The largest distance of a point of the arc from the points of another one.
float farthest_from(const std::vector<Vec2>& arc, const std::vector<Vec2>& other) {
  float farthest = 0;
  for (const Vec2 p : arc) {
    float nearest = std::numeric_limits<float>::infinity();
    for (const Vec2 q : other) nearest = std::min(nearest, norm(p - q));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

}  // namespace

std::optional<ChangedOutline> changed_outline(const std::vector<Vec2>& outline, const std::vector<Vec2>& other,
                                              double part, Draws& draws) {
  const std::vector<Vec2> own = resampled_closed(outline, kPoints);
  std::vector<Vec2> theirs = resampled_closed(other, kPoints);
  const auto growth = float(size_of(outline) / size_of(other));
  for (Vec2& p : theirs) p = p * growth;
  const auto replaced = std::size_t(std::lround(part * kPoints));
  for (int attempt = 0; attempt < kArcTries; ++attempt) {
    const std::size_t first = draws.below(kPoints);
    const std::vector<Vec2> old_arc = arc_of(own, first, replaced);
    const float length = arc_length(old_arc) * (kShortest + (kLongest - kShortest) * draws.unit());
    const float step = closed_length(theirs) / kPoints;
    const auto steps = std::size_t(std::clamp(length / step, 8.f, 0.9f * kPoints));
    std::vector<Vec2> arc = arc_of(theirs, draws.below(kPoints), steps);
    const Similarity laid = onto_ends(arc, old_arc.front(), old_arc.back());
    if (!(laid.scale() >= kLeastScale && laid.scale() <= kMostScale)) continue;
    for (Vec2& p : arc) p = laid.apply(p);
    if (farthest_from(arc, old_arc) < kLeastChange * size_of(outline)) continue;

    ChangedOutline changed{arc_of(own, first + replaced, kPoints - replaced), 0};
    changed.kept = changed.points.size();
    changed.points.insert(changed.points.end(), arc.begin() + 1, arc.end() - 1);
    if (signed_area(changed.points) > 0 && !crosses_itself(changed.points)) return changed;
  }
  return std::nullopt;
}

std::vector<Vec2> outer_outline(const cv::Mat& mask) {
  std::vector<Vec2> longest;
  for (std::vector<Vec2>& contour : contours(coverage_of(mask), 0.5f)) {
    if (longest.empty() || closed_length(contour) > closed_length(longest)) longest = std::move(contour);
  }
  return longest;
}

cv::Mat filled_mask(const std::vector<Vec2>& polygon) {
  const Box box = bounding_box(polygon);
  // The centre of a pixel has whole coordinates in a mask, and halves on the grid.
  const float margin_px = float(kFilledMargin_px) + 0.5f;
  const Similarity grid_from_polygon{1, 0, margin_px - box.low.x, margin_px - box.low.y};
  const Window window{0, 0, int(box.width()) + 2 * kFilledMargin_px + 1, int(box.height()) + 2 * kFilledMargin_px + 1};
  const Grid<std::uint8_t> filled = rasterise({{polygon}}, grid_from_polygon, window);
  cv::Mat mask(filled.height(), filled.width(), CV_8U);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) mask.at<std::uint8_t>(y, x) = filled(x, y) ? 255 : 0;
  }
  return mask;
}

}  // namespace tessera::bench
