// A plane that repeats: a thing at p also lies a whole number of periods away. These copies are its images.
#pragma once

#include <cmath>
#include <vector>

#include "core/geometry/similarity.h"

namespace tessera {

/// The period in canvas px; 0: no repetition in this direction. Without repetition every function returns its argument
/// exactly.
struct Period {
  int x_px = 0;
  int y_px = 0;

  bool repeats() const { return x_px > 0 || y_px > 0; }
  bool repeats_both_ways() const { return x_px > 0 && y_px > 0; }

  /// The image in the first period, [0, period).
  Vec2 wrapped(Vec2 p) const { return {wrapped(p.x, x_px), wrapped(p.y, y_px)}; }
  Similarity wrapped(Similarity canvas_from_shape) const {
    const Vec2 at = wrapped(canvas_from_shape.translation());
    return {canvas_from_shape.a, canvas_from_shape.b, at.x, at.y};
  }

  /// The image of `p` that is nearest to `to`.
  Vec2 nearest(Vec2 p, Vec2 to) const { return {nearest(p.x, to.x, x_px), nearest(p.y, to.y, y_px)}; }

  /// The offsets from a thing to its images up to one period away; first (0, 0), its own place.
  std::vector<Vec2> offsets() const {
    std::vector<Vec2> all = {{}};
    for (int j = y_px > 0 ? -1 : 0; j <= (y_px > 0 ? 1 : 0); ++j) {
      for (int i = x_px > 0 ? -1 : 0; i <= (x_px > 0 ? 1 : 0); ++i) {
        if (i != 0 || j != 0) all.push_back({float(i * x_px), float(j * y_px)});
      }
    }
    return all;
  }

  friend bool operator==(const Period&, const Period&) = default;

 private:
  static float wrapped(float v, int period) {
    if (period == 0) return v;
    const float w = v - float(period) * std::floor(v / float(period));
    return w < float(period) ? w : 0;  // a value slightly below zero is rounded to the period itself
  }
  static float nearest(float v, float to, int period) {
    if (period == 0) return v;
    return v - float(period) * std::floor((v - to) / float(period) + 0.5f);
  }
};

inline Similarity moved(Similarity canvas_from_shape, Vec2 by) {
  canvas_from_shape.tx += by.x;
  canvas_from_shape.ty += by.y;
  return canvas_from_shape;
}

}  // namespace tessera
