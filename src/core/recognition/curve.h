// Curves that are matched in parts: closed outlines, and open arcs, such as an outline that something partly hides. If
// a curve bounds an interior, the interior is on its left.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// A polyline. The last point of a closed one is joined to the first.
struct Curve {
  std::vector<Vec2> points;
  bool closed = false;

  friend bool operator==(const Curve&, const Curve&) = default;
};

/// Curves with more points are refused: a curve of a million points contains no more information than one of ten
/// thousand.
inline constexpr std::size_t kMostCurvePoints = 1u << 22;
/// At coordinates beyond this a float has no decimals.
inline constexpr float kFarthestCoordinate = 1e6f;

/// The reason why these points are no curve, for a message ("it has 1 point; a curve has at least 2"). Empty if they
/// are one.
std::string curve_fault(const Curve& curve);

/// Length of the polyline, including the edge that closes a closed curve.
float length_of(const Curve& curve);

/// `count` points (at least 2) at even arclength. An open curve keeps both ends, a closed one its first point.
Curve resampled(const Curve& curve, int count);

/// A curve of evenly spaced points convolved with a Gaussian of width `sigma` along its length. Open curves are
/// continued beyond their ends by point reflection, so that the ends stay in place.
Curve smoothed(const Curve& even_curve, float sigma);

/// Unit tangents at the points, from neighbour to neighbour; (0, 0) if both neighbours coincide.
std::vector<Vec2> tangents_of(const Curve& curve);

}  // namespace tessera
