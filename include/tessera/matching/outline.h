/// @file
/// Curves for matching and recognition: the outlines of a silhouette, or open lines.
///
/// Any unit of length may be used. The y axis may point down, as in pictures, or up, as in plots, but must be the same in
/// all outlines.
#pragma once

#include <cstddef>
#include <vector>

#include "tessera/matching/export.h"
#include "tessera/matching/similarity.h"

namespace tessera::matching {

/// A polyline. A closed one joins its last point to the first, which is not repeated.
struct Curve {
  std::vector<Point> points;  ///< at least 3 for a closed curve, at least 2 for an open one
  bool closed = true;
};

/// Curves that belong together. A curve that bounds an interior has the interior on its left: the shoelace area of an outer
/// boundary is positive, that of a hole negative. make_outline() gives polygons this direction.
struct Outline {
  std::vector<Curve> curves;

  /// The width (sigma) of the narrowest Gaussian that removes the noise of the points, in the curves' units: 1.5 pixels for
  /// a traced silhouette. 0: 1.5/1024 of the longer side of the bounding box of all curves.
  double smoothing = 0;
};

/// Limits of an outline; check() refuses more curves, or more points in all.
inline constexpr std::size_t kMostCurves = 1000;
inline constexpr std::size_t kMostPoints = std::size_t(1) << 22;

/// Makes closed curves with the interior on the left. A polygon inside an odd number of others is a hole (even-odd rule).
/// Throws Error as check() does.
TESSERA_MATCHING_API Outline make_outline(std::vector<std::vector<Point>> polygons);

/// Throws Error that names the curve. It refuses outlines with no curves or too many; curves with too few points or shorter
/// than a millionth of the whole; coordinates that are not finite or beyond +-1e15; smoothing that is negative or exceeds a
/// 24th of the length of all curves. All functions that take an outline call this first.
TESSERA_MATCHING_API void check(const Outline& outline);

/// The length of all curves together, including the edges that close curves.
TESSERA_MATCHING_API double length_of(const Outline& outline);

/// The area that the closed curves enclose, without holes. Open curves enclose no area.
TESSERA_MATCHING_API double area_of(const Outline& outline);

}  // namespace tessera::matching
