// The pyramid of arclength descriptor (PAD), paper section 3.
//
// At a point of a curve, level i is the interval to the left and right over which the integral of the absolute
// curvature is 2^i delta_tau on each side. The PAD holds these arclengths, each side divided by its longest.
#pragma once

#include <array>

#include "core/geometry/vec2.h"

namespace tessera {

inline constexpr int kMaxPadLevels = 6;
inline constexpr int kMaxPadElements = 2 * (kMaxPadLevels - 1);

/// Paper, section 5: n = 5 and delta_tau = 0.2 in all experiments.
struct PadParameters {
  int levels = 5;          // n, 2..kMaxPadLevels
  float delta_tau = 0.2f;  // rad

  friend bool operator==(const PadParameters&, const PadParameters&) = default;
};

/// The intervals around one point of a curve, in the curve's own units (scale-dependent).
struct ArclengthPyramid {
  std::array<float, kMaxPadLevels> left{};   // l_0 .. l_{n-1}, increasing
  std::array<float, kMaxPadLevels> right{};  // r_0 .. r_{n-1}, increasing
  /// Left end of level n-1, .., left end of level 0, the point itself, right end of level 0, .., right end of level
  /// n-1.
  std::array<Vec2, 2 * kMaxPadLevels + 1> keypoint{};
  float convexity = 0;  // s of the paper: +1 convex (interior bulges out), -1 concave, 0 if the triangle is flat

  friend bool operator==(const ArclengthPyramid&, const ArclengthPyramid&) = default;
};

/// m(p) of the paper: [l_{n-2} .. l_0 r_0 .. r_{n-2}], weighted and normalised, without its sign.
struct Pad {
  std::array<float, kMaxPadElements> element{};
  float convexity = 0;
};

Pad make_pad(const ArclengthPyramid& pyramid, int levels);

/// Equation 1, on the signed vectors s·m: if the convexities are opposite, the magnitudes of each element add up. A
/// flat point agrees with both.
float pad_distance(const Pad& p, const Pad& q, int levels);

/// The PAD for outward docking: reversed order, opposite convexity (paper, end of section 3.2).
Pad flipped(const Pad& pad, int levels);

}  // namespace tessera
