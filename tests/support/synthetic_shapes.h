// Shapes for tests, made from formulas: without artwork or library file, the same on every machine.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/shape/shape.h"

namespace tessera::test {

inline constexpr float kTwoPi = 2 * std::numbers::pi_v<float>;
inline constexpr int kOuterPoints = 512;
inline constexpr int kHolePoints = 64;
inline constexpr int kFieldNodes = 96;

/// The curve r(angle) at `points` even angles. It runs counter-clockwise in numbers, so its shoelace area is positive.
template <class Radius>
std::vector<Vec2> polar_curve(Radius&& r, int points = 4 * kOuterPoints) {
  std::vector<Vec2> curve;
  for (int i = 0; i < points; ++i) {
    const float angle = kTwoPi * float(i) / float(points);
    curve.push_back(Vec2{std::cos(angle), std::sin(angle)} * r(angle));
  }
  return curve;
}

inline std::vector<Vec2> reversed(std::vector<Vec2> curve) {
  std::reverse(curve.begin(), curve.end());
  return curve;
}

inline Outline disc_outline() {
  return {{polar_curve([](float) { return 1.f; })}};
}

inline Outline ring_outline(float hole_radius = 0.5f) {
  return {{polar_curve([](float) { return 1.f; }), reversed(polar_curve([=](float) { return hole_radius; }))}};
}

/// Two rings and a bridge, drawn with lines of this width. The rings have a radius of about 1.
inline Outline spectacles_outline(float line) {
  constexpr float kCentre = 1.35f;
  const float outer = 1 + line / 2;
  const float bridge = std::asin(line / 2 / outer);  // half of the angle at which a ring's centre sees it
  const auto lens = [&](float centre, float from, float to, float radius) {
    std::vector<Vec2> curve = polar_curve([](float) { return 1.f; });
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const float angle = from + (to - from) * float(i) / float(curve.size());
      curve[i] = {centre + radius * std::cos(angle), radius * std::sin(angle)};
    }
    return curve;
  };
  std::vector<Vec2> outside = lens(-kCentre, bridge, kTwoPi - bridge, outer);
  const std::vector<Vec2> right = lens(kCentre, kTwoPi / 2 + bridge, kTwoPi * 1.5f - bridge, outer);
  outside.insert(outside.end(), right.begin(), right.end());
  const float inner = 1 - line / 2;
  return {{outside, reversed(lens(-kCentre, 0, kTwoPi, inner)), reversed(lens(kCentre, 0, kTwoPi, inner))}};
}

/// A shape of straight sides and sharp spikes.
inline Outline star_outline(int spikes, float inner_radius = 0.5f) {
  std::vector<Vec2> curve;
  for (int i = 0; i < 2 * spikes; ++i) {
    const float angle = kTwoPi * float(i) / float(2 * spikes);
    curve.push_back(Vec2{std::cos(angle), std::sin(angle)} * (i % 2 ? inner_radius : 1.f));
  }
  return {{curve}};
}

inline Outline rectangle_outline(float width, float height) {
  return {{{{0, 0}, {width, 0}, {width, height}, {0, height}}}};
}

/// A smooth kidney with one dent.
inline Outline bean_outline() {
  return {{polar_curve([](float a) { return 1 + 0.25f * std::cos(2 * a) - 0.22f * std::cos(3 * a); })}};
}

/// A random smooth blob with a few lobes; the same seed gives the same blob.
inline Outline blob_outline(std::uint32_t seed) {
  std::uint32_t state = seed * 2654435761u + 1;
  const auto next = [&state] {
    state = state * 1664525u + 1013904223u;
    return float(state >> 8) / 16777216.f;
  };
  std::vector<std::pair<float, float>> waves;  // amplitude, phase
  for (int k = 2; k <= 6; ++k) waves.emplace_back(0.35f / float(k) * (0.5f + next()), kTwoPi * next());
  return {{polar_curve([&](float a) {
    float r = 1;
    for (int k = 2; k <= 6; ++k) r += waves[k - 2].first * std::cos(float(k) * a + waves[k - 2].second);
    return std::max(0.2f, r);
  })}};
}

inline double shoelace_area(const std::vector<Vec2>& curve) {
  double sum = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) sum += cross(curve[i], curve[(i + 1) % curve.size()]);
  return sum / 2;
}

inline double shoelace_area(const Outline& outline) {
  double sum = 0;
  for (const auto& curve : outline.curves) sum += shoelace_area(curve);
  return sum;
}

inline Vec2 area_centroid(const Outline& outline) {
  double x = 0;
  double y = 0;
  for (const auto& curve : outline.curves) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec2 p = curve[i];
      const Vec2 q = curve[(i + 1) % curve.size()];
      x += double(cross(p, q)) * (p.x + q.x) / 6;
      y += double(cross(p, q)) * (p.y + q.y) / 6;
    }
  }
  const double area = shoelace_area(outline);
  return {float(x / area), float(y / area)};
}

inline float curve_length(const std::vector<Vec2>& curve) {
  double sum = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) sum += norm(curve[(i + 1) % curve.size()] - curve[i]);
  return float(sum);
}

/// The curve resampled to `points` points at equal arclength. The first point stays.
inline std::vector<Vec2> resampled(const std::vector<Vec2>& curve, int points) {
  std::vector<Vec2> even;
  const float spacing = curve_length(curve) / float(points);
  float at = 0;  // arclength of the next point, counted from curve[i]
  for (std::size_t i = 0; i < curve.size() && int(even.size()) < points; ++i) {
    const Vec2 edge = curve[(i + 1) % curve.size()] - curve[i];
    const float length = norm(edge);
    for (; at < length && int(even.size()) < points; at += spacing) even.push_back(curve[i] + edge * (at / length));
    at -= length;
  }
  return even;
}

inline float distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const float t = std::clamp(dot(p - a, d) / std::max(dot(d, d), 1e-20f), 0.f, 1.f);
  return norm(p - (a + d * t));
}

/// The signed distance to the outline by brute force, positive outside.
inline float signed_distance(const Outline& outline, Vec2 p) {
  float nearest = 1e9f;
  bool inside = false;
  for (const auto& curve : outline.curves) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec2 a = curve[i];
      const Vec2 b = curve[(i + 1) % curve.size()];
      nearest = std::min(nearest, distance_to_segment(p, a, b));
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  }
  return inside ? -nearest : nearest;
}

inline ShapeField brute_force_field(const Outline& outline, float radius) {
  ShapeField field{Grid<float>(kFieldNodes, kFieldNodes), radius + 0.15f};
  for (int j = 0; j < kFieldNodes; ++j) {
    for (int i = 0; i < kFieldNodes; ++i) {
      const auto at = [&](int k) { return field.extent * (2.f * float(k) / (kFieldNodes - 1) - 1); };
      field.distance(i, j) = signed_distance(outline, {at(i), at(j)});
    }
  }
  return field;
}

/// Makes a library shape in its own frame from an outline of any size and place. It fills outline, perimeter, radius and field; the levels
/// stay empty.
/// The artwork is a page of 100 px with the shape in its middle and no file.
inline Shape make_test_shape(const std::string& name, const Outline& raw) {
  Shape shape;
  shape.name = name;
  const Vec2 centroid = area_centroid(raw);
  const float unit = std::sqrt(float(shoelace_area(raw)));
  for (std::size_t c = 0; c < raw.curves.size(); ++c) {
    std::vector<Vec2> curve = resampled(raw.curves[c], c == 0 ? kOuterPoints : kHolePoints);
    for (Vec2& p : curve) p = (p - centroid) * (1 / unit);
    for (const Vec2 p : curve) shape.radius = std::max(shape.radius, norm(p));
    shape.perimeter += curve_length(curve);
    shape.outline.curves.push_back(std::move(curve));
  }
  shape.field = brute_force_field(shape.outline, shape.radius);
  shape.mean_lab = {60, 0, 0};
  shape.artwork.width_px = shape.artwork.height_px = 100;
  shape.artwork.centroid_px = {50, 50};
  shape.artwork.unit_px = 48 / shape.radius;
  return shape;
}

}  // namespace tessera::test
