#include "bench/blocking/seen_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "bench/blocking/jpeg_copy.h"
#include "core/geometry/contour.h"
#include "core/geometry/polygon.h"
#include "core/geometry/similarity.h"

namespace tessera::bench {
namespace {

constexpr int kRim_px = 8;  // clear pixels round a turned mask
constexpr double kLeastArea_px2 = 9;
constexpr float kLeastLength_px = 16;
/// Limits for the arcs that remain when the hider's edge is cut out.
constexpr std::size_t kLeastArcPoints = 8;
constexpr float kLeastArc_px = 12;
/// Points this near to the hider lie on its edge: px of the coarser of mask and query, and a multiple of the noise.
constexpr double kEdgeWidth_px = 1.5;
constexpr double kEdgeNoise = 1.5;
/// A mask that is drawn smaller is averaged first, by this part of the query's pixel; its own pixels average the rest.
constexpr double kAveraging = 0.5;
constexpr double kOwnAveraging_px = 0.3;
constexpr double kReduced = 0.9;

struct TurnedMask {
  cv::Mat mask;
  Similarity query_from_mask;
};

/// The part of the mask within `box`, turned and scaled into a mask just large enough.
TurnedMask turned_mask(const cv::Mat& mask, const cv::Rect& box, const View& view) {
  const double a = std::cos(view.turned_rad) * view.size;
  const double b = std::sin(view.turned_rad) * view.size;
  const double width = std::abs(a) * box.width + std::abs(b) * box.height + 2 * kRim_px;
  const double height = std::abs(b) * box.width + std::abs(a) * box.height + 2 * kRim_px;
  const double x = box.x + box.width * 0.5;
  const double y = box.y + box.height * 0.5;
  const cv::Mat matrix =
      (cv::Mat_<double>(2, 3) << a, -b, width / 2 - (a * x - b * y), b, a, height / 2 - (b * x + a * y));
  cv::Mat averaged = mask;
  if (view.size < kReduced) {
    cv::GaussianBlur(mask, averaged, {}, std::max(kOwnAveraging_px, kAveraging / view.size - kOwnAveraging_px));
  }
  cv::Mat turned;
  cv::warpAffine(averaged, turned, matrix, {int(width) + 1, int(height) + 1}, cv::INTER_LINEAR);
  return {turned > 127, {float(a), float(b), float(matrix.at<double>(0, 2)), float(matrix.at<double>(1, 2))}};
}

/// A random number with the normal distribution (Box and Muller 1958).
float normal_number(Draws& draws) {
  const double radius = std::sqrt(-2 * std::log(1 - double(draws.unit())));
  return float(radius * std::cos(2 * std::numbers::pi * double(draws.unit())));
}

/// The curve at points 1 px apart, each moved across it at random.
Curve noisy(const Curve& closed, double noise_px, Draws& draws) {
  Curve result = resampled(closed, std::max(16, int(length_of(closed))));
  const std::vector<Vec2> tangents = tangents_of(result);
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const Vec2 across{-tangents[i].y, tangents[i].x};
    result.points[i] = result.points[i] + across * (float(noise_px) * normal_number(draws));
  }
  return result;
}

/// Adds the arcs of a closed curve between points on the hider's edge; the whole curve where it has no such points.
template <class OnEdge>
void add_arcs(const Curve& closed, const OnEdge& on_edge, std::vector<Curve>& arcs) {
  const std::size_t count = closed.points.size();
  std::size_t first = 0;
  while (first < count && !on_edge(closed.points[first])) ++first;
  if (first == count) {
    arcs.push_back(closed);
    return;
  }
  Curve arc;
  for (std::size_t k = 1; k <= count; ++k) {
    const Vec2 p = closed.points[(first + k) % count];
    if (!on_edge(p)) {
      arc.points.push_back(p);
      continue;
    }
    if (arc.points.size() >= kLeastArcPoints && length_of(arc) > kLeastArc_px) arcs.push_back(arc);
    arc.points.clear();
  }
}

}  // namespace

Grid<float> coverage_of(const cv::Mat& mask) {
  Grid<float> coverage(mask.cols, mask.rows);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) coverage(x, y) = float(mask.at<std::uint8_t>(y, x)) / 255;
  }
  return coverage;
}

std::vector<Curve> seen_curves(const cv::Mat& seen, const View& view, const HiderDistance& from_hider, Draws& draws) {
  const cv::Rect box = cv::boundingRect(seen);
  if (box.empty()) return {};
  TurnedMask turned = turned_mask(seen, box, view);
  if (view.jpeg_quality > 0) turned.mask = jpeg_copy(turned.mask, view.jpeg_quality);
  const Similarity mask_from_query = turned.query_from_mask.inverse();
  const double reach_px = kEdgeWidth_px * std::max(1., view.size) + kEdgeNoise * view.noise_px;
  const auto on_edge = [&](Vec2 p) { return from_hider(mask_from_query.apply(p)) * view.size < reach_px; };
  std::vector<Curve> curves;
  for (std::vector<Vec2>& points : contours(coverage_of(turned.mask), 0.5f)) {
    Curve curve{std::move(points), true};
    if (std::abs(signed_area(curve.points)) < kLeastArea_px2 || length_of(curve) < kLeastLength_px) continue;
    if (view.noise_px > 0) curve = noisy(curve, view.noise_px, draws);
    if (from_hider) {
      add_arcs(curve, on_edge, curves);
    } else {
      curves.push_back(curve);
    }
  }
  return curves;
}

}  // namespace tessera::bench
