// Curves that are matched in parts: closed outlines, and open arcs, as an outline has where something covers the rest of
// it. A curve that bounds an interior has it on its left.
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

/// More points than this are refused: a curve of a million points holds nothing that one of ten thousand does not.
inline constexpr std::size_t kMostCurvePoints = 1u << 22;
/// Coordinates beyond this leave a float no decimals.
inline constexpr float kFarthestCoordinate = 1e6f;

/// Why these points are no curve, for a message ("it has 1 point; a curve has at least 2"). Empty where they are one.
std::string curve_fault(const Curve& curve);

/// Length of the polyline; the edge that closes a curve counts.
float length_of(const Curve& curve);

/// `count` points at even arclength, at least 2. Of an open curve both ends are kept, of a closed one the first point.
Curve resampled(const Curve& curve, int count);

/// A curve of evenly spaced points convolved with a Gaussian of width `sigma` along its length. Open curves go on
/// beyond their ends as their point reflections, so that the ends stay where they are.
Curve smoothed(const Curve& even_curve, float sigma);

/// Unit tangents at the points, from neighbour to neighbour; (0, 0) where both neighbours are one point.
std::vector<Vec2> tangents_of(const Curve& curve);

}  // namespace tessera
