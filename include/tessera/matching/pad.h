/// @file
/// The pyramid of arclength descriptor (PAD) of Kwan et al., "Pyramid of Arclength Descriptor for Generating Collage of
/// Shapes" (SIGGRAPH Asia 2016), section 3.2.
///
/// Around a point of a curve, level i reaches so far to the left and to the right that the integral of the absolute
/// curvature over each side is 2^i times delta_tau. A PAD holds these arclengths. 0.024 divided by the width of the
/// smoothing is taken off the curvature first: so much is noise of straight lines.
#pragma once

#include <cstddef>
#include <vector>

#include "tessera/matching/export.h"
#include "tessera/matching/outline.h"

namespace tessera::matching {

struct PadSettings {
  int levels = 5;              ///< 2 to 6
  double delta_tau_rad = 0.2;  ///< turning of level 0 on each side, 0.01 to 1
  /// Width (sigma) of the Gaussian that smooths the curves first, in their units: PADs agree where the curves were smoothed
  /// by the same part of their size. 0: a hundredth of the length of all curves.
  double smoothing = 0;
  int samples = 64;  ///< of all curves together, 1 to 100,000; they are evenly spaced along each curve
};

/// The arclengths round one point.
struct Pad {
  std::size_t curve = 0;           ///< of the outline
  double along = 0;                ///< arclength from the curve's first point to this one, in the curve's units
  Point position = {};             ///< on the smoothed curve
  std::vector<double> left = {};   ///< arclength of levels 0, 1, ..., in the curve's units, increasing
  std::vector<double> right = {};  ///< the same on the other side
  int convexity = 0;               ///< +1: the interior bulges out here, -1: it is drawn in, 0: the curve is flat
};

/// PADs along all curves. Near the ends of an open curve, levels that would run off the end are missing: `left` and
/// `right` are shorter there, and may be empty. A closed curve has all levels. A curve shorter than six widths of the
/// smoothing has lost its shape and gets no PADs.
///
/// Throws Error as check() does, and where a setting is out of its range.
TESSERA_MATCHING_API std::vector<Pad> pads_of(const Outline& outline, const PadSettings& settings = {});

/// Equation 1 of the paper: the largest difference of an element, where elements are arclengths divided by the longest of
/// their side, level i weighted by 2^-i, and add up where one PAD is convex and the other concave. 0 to 2. It does not
/// depend on scale, rotation and place. Both PADs need the same levels and delta_tau.
///
/// Only levels that both have count, and each side is divided by the longest of these. Where they have fewer than 2 levels of
/// a side in common, they cannot be compared, and the distance is infinite.
TESSERA_MATCHING_API double pad_distance(const Pad& p, const Pad& q);

}  // namespace tessera::matching
