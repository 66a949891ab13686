// Outlines for tests of the public library.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "support/random_curves.h"
#include "tessera/matching/matching.h"

namespace tessera::test {

/// An outline without symmetry, with the interior on the left and a radius of 2 to 3.
inline matching::Outline random_outline(std::uint32_t seed, int points = 400) {
  matching::Outline outline;
  matching::Curve& curve = outline.curves.emplace_back();
  for (const Vec2 p : random_curve(seed, points)) curve.points.push_back({p.x, p.y});
  return outline;
}

inline matching::Outline circle(double radius, int points = 360) {
  matching::Outline outline;
  matching::Curve& curve = outline.curves.emplace_back();
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * M_PI * i / points;
    curve.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

/// A disc of radius 3 with a hole of radius 1.
inline matching::Outline ring() {
  return matching::make_outline({circle(3).curves[0].points, circle(1).curves[0].points});
}

inline matching::Outline mapped(matching::Outline outline, const matching::Similarity& map) {
  for (matching::Curve& curve : outline.curves) {
    for (matching::Point& p : curve.points) p = map.apply(p);
  }
  outline.smoothing *= map.scale();
  return outline;
}

inline matching::Similarity similarity(double scale, double rotation_rad, double tx, double ty) {
  return {scale * std::cos(rotation_rad), scale * std::sin(rotation_rad), tx, ty};
}

/// The message of the Error; empty if there is none.
inline std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const matching::Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace tessera::test
