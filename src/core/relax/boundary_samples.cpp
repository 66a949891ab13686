#include "core/relax/boundary_samples.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/curve_corners.h"

namespace tessera {
namespace {

using Curve = std::vector<Vec2>;

/// Adds even steps along the vertices from `from` up to, but without, `to`, which may be past the curve's end.
void add_steps(const Curve& curve, std::size_t from, std::size_t to, float spacing, std::vector<BoundarySample>& all) {
  const auto vertex = [&](std::size_t i) { return curve[i % curve.size()]; };
  float length = 0;
  for (std::size_t i = from; i < to; ++i) length += norm(vertex(i + 1) - vertex(i));
  const int steps = std::max(1, int(std::ceil(length / spacing)));
  const float step = length / float(steps);
  int made = 0;
  float passed = 0;
  for (std::size_t i = from; i < to && made < steps; ++i) {
    const Vec2 edge = vertex(i + 1) - vertex(i);
    const float edge_length = norm(edge);
    for (; made < steps && float(made) * step <= passed + edge_length; ++made) {
      const float part = edge_length > 0 ? (float(made) * step - passed) / edge_length : 0.f;
      all.push_back({vertex(i) + edge * part, step});
    }
    passed += edge_length;
  }
}

}  // namespace

BoundarySamples sample_boundary(const Outline& outline, float spacing, float tolerance) {
  BoundarySamples all;
  for (const Curve& curve : outline.curves) {
    std::vector<BoundarySample> samples;  // here `length` is the step after the sample
    const std::vector<std::size_t> corners = curve_corners(curve, tolerance);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const std::size_t next = c + 1 < corners.size() ? corners[c + 1] : curve.size();
      add_steps(curve, corners[c], next, spacing, samples);
    }
    float before = samples.back().length;
    for (BoundarySample& sample : samples) {
      all.longest_step = std::max(all.longest_step, sample.length);
      const float after = sample.length;
      sample.length = 0.5f * (before + after);
      before = after;
    }
    all.samples.insert(all.samples.end(), samples.begin(), samples.end());
    all.curve_ends.push_back(all.samples.size());
  }
  return all;
}

}  // namespace tessera
