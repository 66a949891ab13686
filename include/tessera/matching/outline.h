/// @file
/// Curves that are matched and recognised: the outlines of a silhouette, or open lines.
///
/// Any unit of length will do. The y axis may point down, as in pictures, or up, as in plots, but in all outlines alike.
#pragma once

#include <cstddef>
#include <vector>

#include "tessera/matching/export.h"
#include "tessera/matching/similarity.h"

namespace tessera::matching {

/// A polyline. The last point of a closed one is joined to the first, and is not repeated.
struct Curve {
  std::vector<Point> points;  ///< at least 3 of a closed curve, at least 2 of an open one
  bool closed = true;
};

/// Curves that belong together. A curve that bounds an interior has the interior on its left: the shoelace area of an
/// outer boundary is positive, that of a hole negative. make_outline() turns polygons that way round.
struct Outline {
  std::vector<Curve> curves;

  /// Width (sigma) of the narrowest Gaussian that takes the noise of the points out, in the curves' units: 1.5 pixels of
  /// a traced silhouette. 0: 1.5/1024 of the longer side of the box round all curves.
  double smoothing = 0;
};

/// An outline with more curves, or more points in all, is refused.
inline constexpr std::size_t kMostCurves = 1000;
inline constexpr std::size_t kMostPoints = std::size_t(1) << 22;

/// Closed curves, each with the interior on its left: polygons within an odd number of others are holes (even-odd
/// rule). Throws Error as check() does.
TESSERA_MATCHING_API Outline make_outline(std::vector<std::vector<Point>> polygons);

/// Throws Error, which names the curve, where there are no curves or too many, where a curve has too few points or is shorter
/// than a millionth of the whole, where a coordinate is not finite or beyond +-1e15, and where the smoothing is negative or
/// exceeds a 24th of the length of all curves. All functions that take an outline begin with this.
TESSERA_MATCHING_API void check(const Outline& outline);

/// The length of all curves together; the edge that closes a curve counts.
TESSERA_MATCHING_API double length_of(const Outline& outline);

/// The area that the closed curves enclose, holes taken off. Open curves enclose none.
TESSERA_MATCHING_API double area_of(const Outline& outline);

}  // namespace tessera::matching
