#include "core/relax/boundary_samples.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tessera {
namespace {

using Curve = std::vector<Vec2>;

float distance_to_chord(Vec2 p, Vec2 from, Vec2 to) {
  const Vec2 chord = to - from;
  const float length = norm(chord);
  return length > 0 ? std::abs(cross(chord, p - from)) / length : norm(p - from);
}

std::size_t farthest_from_first(const Curve& curve) {
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (norm(curve[i] - curve[0]) > norm(curve[farthest] - curve[0])) farthest = i;
  }
  return farthest;
}

/// Indices of the vertices that the Douglas-Peucker algorithm keeps, ascending.
std::vector<std::size_t> corners_of(const Curve& curve, float tolerance) {
  const std::size_t middle = farthest_from_first(curve);
  std::vector<std::size_t> corners{0};
  if (middle > 0) corners.push_back(middle);
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, middle}, {middle, curve.size()}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    float most = tolerance;
    std::size_t corner = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const float away = distance_to_chord(curve[i], curve[from], curve[to % curve.size()]);
      if (away <= most) continue;
      most = away;
      corner = i;
    }
    if (corner == from) continue;
    corners.push_back(corner);
    open.emplace_back(from, corner);
    open.emplace_back(corner, to);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

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
    const std::vector<std::size_t> corners = corners_of(curve, tolerance);
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
