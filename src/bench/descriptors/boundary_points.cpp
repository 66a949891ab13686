#include "bench/descriptors/boundary_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tessera::bench {
namespace {

/// The width of the smoothing before tangents are taken.
constexpr float kTangentSmoothing = 0.01f;
constexpr int kSmoothedPoints = 400;

/// Adds evenly spaced points; the first one is half a step from the curve's start.
void add_even_points(const Curve& curve, int count, float sigma, EvenPoints& points) {
  const Curve fine = resampled(curve, kSmoothedPoints);
  const std::vector<Vec2> tangents = tangents_of(smoothed(fine, sigma));
  for (int i = 0; i < count; ++i) {
    const auto at = std::size_t((float(i) + 0.5f) * kSmoothedPoints / float(count));
    points.position.push_back(fine.points[at]);
    points.tangent.push_back(tangents[at]);
  }
}

float row_difference(const float* a, const float* b, std::size_t row) {
  float sum = 0;
  for (std::size_t k = 0; k < row; ++k) sum += std::abs(a[k] - b[k]);
  return sum / float(row);
}

}  // namespace

float length_of_all(const std::vector<Curve>& curves) {
  float length = 0;
  for (const Curve& curve : curves) length += length_of(curve);
  return length;
}

EvenPoints even_points(const std::vector<Curve>& curves, int count) {
  const float whole = length_of_all(curves);
  EvenPoints points;
  float length = 0;
  int had = 0;
  for (const Curve& curve : curves) {
    length += length_of(curve);
    const int wanted = &curve == &curves.back() ? count : int(std::lround(float(count) * length / whole));
    if (wanted > had) add_even_points(curve, wanted - had, kTangentSmoothing * whole, points);
    had = std::max(had, wanted);
  }
  return points;
}

Curve closed_boundary(const std::vector<Curve>& curves) {
  Curve arcs{{}, true};
  const Curve* longest = nullptr;
  float closed_length = 0, arc_length = 0;
  for (const Curve& curve : curves) {
    const float length = length_of(curve);
    if (!curve.closed) {
      arcs.points.insert(arcs.points.end(), curve.points.begin(), curve.points.end());
      arc_length += length;
    } else if (length > closed_length) {
      longest = &curve;
      closed_length = length;
    }
  }
  if (arc_length > closed_length && arcs.points.size() > 2) return arcs;
  return longest ? *longest : curves.front();
}

float warped_difference(const std::vector<float>& query, const std::vector<float>& known, std::size_t row) {
  const std::size_t queries = query.size() / row;
  const std::size_t places = known.size() / row;
  // The rows come twice, so that a path may pass the place where they begin.
  std::vector<float> before(2 * places, 0.f), sums(2 * places), differences(places);
  for (std::size_t i = 0; i < queries; ++i) {
    for (std::size_t j = 0; j < places; ++j) {
      differences[j] = row_difference(query.data() + i * row, known.data() + j * row, row);
    }
    for (std::size_t j = 0; j < 2 * places; ++j) {
      float least = before[j];
      if (i > 0 && j > 0) least = std::min({least, before[j - 1], sums[j - 1]});
      sums[j] = least + differences[j % places];
    }
    std::swap(before, sums);
  }
  return *std::min_element(before.begin(), before.end()) / float(queries);
}

}  // namespace tessera::bench
