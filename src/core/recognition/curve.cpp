#include "core/recognition/curve.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/closed_curve.h"

namespace tessera {
namespace {

/// A point of an open curve, or of its point reflections at both ends.
Vec2 reflected_point(const std::vector<Vec2>& points, int i) {
  const int last = int(points.size()) - 1;
  if (i < 0) return points[0] * 2 - points[std::size_t(-i)];
  if (i > last) return points[std::size_t(last)] * 2 - points[std::size_t(2 * last - i)];
  return points[std::size_t(i)];
}

std::vector<float> gaussian_weights(int reach, float spacing, float sigma) {
  std::vector<float> weight(std::size_t(reach) + 1);
  float total = 0;
  for (int k = 0; k <= reach; ++k) {
    const float t = float(k) * spacing / sigma;
    weight[std::size_t(k)] = std::exp(-0.5f * t * t);
    total += (k ? 2 : 1) * weight[std::size_t(k)];
  }
  for (float& w : weight) w /= total;
  return weight;
}

std::vector<Vec2> resampled_open(const std::vector<Vec2>& points, float length, int count) {
  std::vector<Vec2> result;
  result.reserve(std::size_t(count));
  const double step = double(length) / (count - 1);
  std::size_t edge = 0;
  double edge_start = 0;
  double edge_length = norm(points[1] - points[0]);
  for (int i = 0; i < count; ++i) {
    const double at = step * i;
    while (edge + 2 < points.size() && edge_start + edge_length < at) {
      edge_start += edge_length;
      ++edge;
      edge_length = norm(points[edge + 1] - points[edge]);
    }
    const double t = edge_length > 0 ? std::min(1.0, (at - edge_start) / edge_length) : 0.0;
    result.push_back(points[edge] + (points[edge + 1] - points[edge]) * float(t));
  }
  return result;
}

}  // namespace

std::string curve_fault(const Curve& curve) {
  const std::size_t least = curve.closed ? 3 : 2;
  const std::size_t count = curve.points.size();
  if (count < least) {
    return "it has " + std::to_string(count) + (count == 1 ? " point" : " points") + "; " +
           (curve.closed ? "a closed curve has at least 3" : "an open curve has at least 2");
  }
  if (count > kMostCurvePoints) {
    return "it has " + std::to_string(count) + " points; at most " + std::to_string(kMostCurvePoints) + " are allowed";
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 p = curve.points[i];
    if (!(std::abs(p.x) <= kFarthestCoordinate && std::abs(p.y) <= kFarthestCoordinate)) {
      return "point " + std::to_string(i) + " is not a number, or lies beyond +-1e6";
    }
  }
  if (!(length_of(curve) > 0)) return "all its points are one";
  return {};
}

float length_of(const Curve& curve) {
  if (curve.closed) return closed_length(curve.points);
  double length = 0;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) length += norm(curve.points[i + 1] - curve.points[i]);
  return float(length);
}

Curve resampled(const Curve& curve, int count) {
  if (curve.closed) return {resampled_closed(curve.points, count), true};
  return {resampled_open(curve.points, length_of(curve), count), false};
}

Curve smoothed(const Curve& even_curve, float sigma) {
  if (even_curve.closed) return {gaussian_smoothed(even_curve.points, sigma), true};
  const int count = int(even_curve.points.size());
  const float spacing = length_of(even_curve) / float(count - 1);
  const int reach = std::min(count - 1, int(3 * sigma / spacing));
  const std::vector<float> weight = gaussian_weights(reach, spacing, sigma);
  Curve result{std::vector<Vec2>(std::size_t(count)), false};
  for (int i = 0; i < count; ++i) {
    Vec2 sum = even_curve.points[std::size_t(i)] * weight[0];
    for (int k = 1; k <= reach; ++k) {
      sum = sum + (reflected_point(even_curve.points, i + k) + reflected_point(even_curve.points, i - k)) *
                      weight[std::size_t(k)];
    }
    result.points[std::size_t(i)] = sum;
  }
  return result;
}

std::vector<Vec2> tangents_of(const Curve& curve) {
  const std::size_t count = curve.points.size();
  std::vector<Vec2> tangents(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t after = i + 1 < count ? i + 1 : curve.closed ? 0 : i;
    const std::size_t before = i > 0 ? i - 1 : curve.closed ? count - 1 : 0;
    const Vec2 chord = curve.points[after] - curve.points[before];
    const float length = norm(chord);
    if (length > 0) tangents[i] = chord * (1 / length);
  }
  return tangents;
}

}  // namespace tessera
