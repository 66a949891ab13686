#include "core/recognition/query.h"

#include <algorithm>
#include <cmath>

#include "core/recognition/curve_noise.h"

namespace tessera {
namespace {

/// Sizes of the map, as fractions of the query's radius; kLeastMapCell is a fraction of its extent.
constexpr float kMapCell = 1.f / 48;
constexpr float kLeastMapCell = 1.f / 512;
constexpr float kMapReach = 0.16f;
constexpr float kMapPoints = 1.f / 96;
/// The map's curves are smoothed by this fraction of the narrowest width: enough to remove the stairs of pixels.
constexpr float kMapSmoothing = 2.f / 3;

/// The widest smoothing, as a fraction of the curves' length.
constexpr float kWidest = 1.f / 12;
/// Number of points per width with which a curve is smoothed.
constexpr float kPointsOfWidth = 4;
constexpr int kLeastPoints = 48;
constexpr int kMostPoints = 2000;
constexpr int kMostMapPoints = 20000;
/// Curves shorter than this many widths have lost their shape and give no PADs.
constexpr float kShortestCurve = 6;
/// Distance of PADs in widths. It is larger if more than kMostPads would be looked up along the length.
constexpr float kPadSpacing = 1.5f;
constexpr float kMostPads = 10;
/// Each curve has at least this number of PADs, however short it is: a shape seen between bars is many short curves.
constexpr float kLeastPadsOfCurve = 8;
/// Number of levels that inner_levels() keeps.
constexpr int kInnerLevels = 3;

/// Only the first levels of each side. Beyond them something other than the shape may follow: the edge at which a shape
/// was clipped, or an object that hides the rest.
PartialPyramid inner_levels(PartialPyramid pyramid) {
  pyramid.left_levels = std::min(pyramid.left_levels, kInnerLevels);
  pyramid.right_levels = std::min(pyramid.right_levels, kInnerLevels);
  return pyramid;
}

QueryWidth make_width(const std::vector<Curve>& curves, float sigma, float length, const PadParameters& pad) {
  QueryWidth width{sigma, {}};
  for (const Curve& curve : curves) {
    const float own = length_of(curve);
    const float spacing = std::max(kPadSpacing * sigma, std::min(length / kMostPads, own / kLeastPadsOfCurve));
    if (own < std::max(kShortestCurve * sigma, kShortestShare * length)) continue;
    const int count = int(std::clamp<float>(own * kPointsOfWidth / sigma, kLeastPoints, kMostPoints));
    const int stride = std::max(1, int(spacing * float(count) / own));
    for (const PartialPyramid& p : partial_pyramids(smoothed(resampled(curve, count), sigma), sigma, stride, pad)) {
      if (has_enough_levels(p)) width.pyramids.push_back(p);
      const bool has_more = std::max(p.left_levels, p.right_levels) > kInnerLevels;
      if (curve.closed && has_more && has_enough_levels(inner_levels(p))) width.pyramids.push_back(inner_levels(p));
    }
  }
  return width;
}

std::vector<Curve> large_curves(const std::vector<Curve>& curves, float length) {
  std::vector<Curve> large;
  for (const Curve& curve : curves) {
    if (length_of(curve) >= kShortestShare * length) large.push_back(curve);
  }
  return large;
}

std::vector<Curve> cleaned(const std::vector<Curve>& curves, float sigma) {
  std::vector<Curve> result;
  for (const Curve& curve : curves) result.push_back(without_noise(curve, sigma));
  return result;
}

}  // namespace

Query::Measures Query::measure(const std::vector<Curve>& curves) {
  Measures result{};
  Vec2 low = curves.front().points.front();
  Vec2 high = low;
  double x = 0, y = 0, squares = 0, count = 0;
  for (const Curve& curve : curves) {
    const float length = length_of(curve);
    result.length += length;
    const Curve even = resampled(curve, 256);
    for (const Vec2 p : even.points) {
      const double weight = double(length) / 256;
      x += weight * p.x;
      y += weight * p.y;
      squares += weight * dot(p, p);
      count += weight;
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  result.centre = {float(x / count), float(y / count)};
  const double variance = squares / count - (x / count) * (x / count) - (y / count) * (y / count);
  result.extent = std::max(high.x - low.x, high.y - low.y);
  result.radius = std::max(float(std::sqrt(std::max(variance, 0.0))), 1e-3f * result.extent);
  return result;
}

CurveMap Query::make_map(const std::vector<Curve>& curves, float sigma, const Measures& measures) {
  const std::vector<Curve> even = even_curves(curves, sigma, kMapPoints * measures.radius);
  const float cell = std::max(kMapCell * measures.radius, kLeastMapCell * measures.extent);
  return CurveMap(even, cell, kMapReach * measures.radius);
}

std::vector<Curve> even_curves(const std::vector<Curve>& curves, float sigma, float spacing) {
  std::vector<Curve> even;
  const auto bounded = [](float points) { return int(std::clamp<float>(points, kLeastPoints, kMostMapPoints)); };
  for (const Curve& curve : curves) {
    const float length = length_of(curve);
    const Curve smooth = smoothed(resampled(curve, bounded(2 * length / sigma)), sigma);
    even.push_back(resampled(smooth, bounded(length / spacing)));
  }
  return even;
}

Query::Query(const std::vector<Curve>& curves, const QuerySettings& settings)
    : Query(curves, settings, measure(curves)) {
  if (!settings.without_noise) return;
  const std::vector<Curve> without = cleaned(curves, settings.least_sigma);
  if (without != curves) without_noise_.reset(new Query(without, settings, measure(without)));
}

Query::Query(const std::vector<Curve>& curves, const QuerySettings& settings, const Measures& measures)
    : map_(make_map(curves, kMapSmoothing * settings.least_sigma, measures)),
      measures_(measures),
      least_sigma_(settings.least_sigma),
      narrow_curves_(even_curves(large_curves(curves, measures.length), settings.least_sigma, settings.least_sigma)) {
  for (float sigma = settings.least_sigma; sigma < kWidest * measures.length; sigma *= kWidthStep) {
    widths_.push_back(make_width(curves, sigma, measures.length, settings.pad));
  }
}

}  // namespace tessera
