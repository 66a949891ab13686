#include "core/geometry/closed_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tessera {

float closed_length(const std::vector<Vec2>& curve) {
  double length = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) length += norm(curve[(i + 1) % curve.size()] - curve[i]);
  return float(length);
}

std::vector<Vec2> resampled_closed(const std::vector<Vec2>& curve, int count) {
  const std::size_t n = curve.size();
  const double step = double(closed_length(curve)) / count;
  std::vector<Vec2> result;
  result.reserve(count);
  double edge_start = 0;
  std::size_t edge = 0;
  double edge_length = norm(curve[1 % n] - curve[0]);
  for (int i = 0; i < count; ++i) {
    const double at = step * i;
    while (edge + 1 < n && edge_start + edge_length < at) {
      edge_start += edge_length;
      ++edge;
      edge_length = norm(curve[(edge + 1) % n] - curve[edge]);
    }
    const double t = edge_length > 0 ? std::min(1.0, (at - edge_start) / edge_length) : 0.0;
    result.push_back(curve[edge] + (curve[(edge + 1) % n] - curve[edge]) * float(t));
  }
  return result;
}

std::vector<Vec2> gaussian_smoothed(const std::vector<Vec2>& even_curve, float sigma) {
  const int n = int(even_curve.size());
  const float spacing = closed_length(even_curve) / float(n);
  const int reach = std::min(n / 2 - 1, int(3 * sigma / spacing));
  std::vector<float> weight(reach + 1);
  float total = 0;
  for (int k = 0; k <= reach; ++k) {
    const float t = float(k) * spacing / sigma;
    weight[k] = std::exp(-0.5f * t * t);
    total += k ? 2 * weight[k] : weight[k];
  }
  for (float& w : weight) w /= total;
  std::vector<Vec2> padded(n + 2 * reach);
  for (int i = 0; i < n + 2 * reach; ++i) padded[i] = even_curve[(i - reach + n) % n];
  // The loop over the points is the inner one, because it runs over plain memory and has no sum to wait for.
  std::vector<Vec2> result(n);
  for (int i = 0; i < n; ++i) result[i] = padded[i + reach] * weight[0];
  for (int k = 1; k <= reach; ++k) {
    const float w = weight[k];
    const Vec2 *before = padded.data() + reach - k, *after = padded.data() + reach + k;
    for (int i = 0; i < n; ++i) result[i] = result[i] + (after[i] + before[i]) * w;
  }
  return result;
}

}  // namespace tessera
