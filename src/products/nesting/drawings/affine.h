// Affine maps of the plane, for drawings inside other drawings.
#pragma once

#include <cmath>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

/// Maps (x, y) to (a x + c y + e, b x + d y + f).
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  NestPoint apply(NestPoint p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// Maps a direction, without the shift.
  NestPoint turned(NestPoint v) const { return {a * v.x + c * v.y, b * v.x + d * v.y}; }
  /// The map that applies `inner` first, then this map.
  Affine after(const Affine& inner) const {
    const NestPoint x = turned({inner.a, inner.b}), y = turned({inner.c, inner.d}), at = apply({inner.e, inner.f});
    return {x.x, x.y, y.x, y.y, at.x, at.y};
  }
  /// Whether all numbers are finite and at most `most`.
  bool is_within(double most) const {
    const auto within = [&](double x) { return std::abs(x) <= most; };
    return within(a) && within(b) && within(c) && within(d) && within(e) && within(f);
  }
};

}  // namespace tessera
