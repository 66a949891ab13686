/// @file
/// The pyramid of arclength descriptor (PAD) of Kwan et al., "Pyramid of Arclength Descriptor for Generating Collage of
/// Shapes" (SIGGRAPH Asia 2016), section 3.2.
///
/// Around a point of a curve, level i reaches as far to each side as the integral of the absolute curvature there is 2^i
/// times delta_tau. A PAD holds these arclengths. Before that, 0.024 divided by the width of the smoothing is subtracted
/// from the curvature: straight lines have this much noise.
#pragma once

#include <cstddef>
#include <vector>

#include "tessera/matching/export.h"
#include "tessera/matching/outline.h"

namespace tessera::matching {

struct PadSettings {
  int levels = 5;              ///< 2 to 6
  double delta_tau_rad = 0.2;  ///< turning of level 0 on each side, 0.01 to 1
  /// The width (sigma) of the Gaussian that first smooths the curves, in their units. PADs of two outlines agree where both
  /// were smoothed by the same part of their size. 0: a hundredth of the length of all curves.
  double smoothing = 0;
  int samples = 64;  ///< of all curves together, 1 to 100,000, evenly spaced along each curve
};

/// The arclengths around one point of a curve.
struct Pad {
  std::size_t curve = 0;           ///< index of the curve in its outline
  double along = 0;                ///< arclength from the curve's first point to this one, in the curve's units
  Point position = {};             ///< on the smoothed curve
  std::vector<double> left = {};   ///< arclength of levels 0, 1, ..., in the curve's units, increasing
  std::vector<double> right = {};  ///< the same on the other side
  int convexity = 0;               ///< +1: the interior bulges outward here, -1: inward, 0: the curve is flat
};

/// The PADs along all curves. Near the ends of an open curve, levels that would run over the end are missing: `left` and
/// `right` are shorter there and may be empty. A closed curve has all levels. A curve shorter than six widths of the
/// smoothing has lost its shape and gets no PADs.
///
/// Throws Error like check(), and where a setting is out of its range.
TESSERA_MATCHING_API std::vector<Pad> pads_of(const Outline& outline, const PadSettings& settings = {});

/// The distance of two PADs, 0 to 2 (equation 1 of the paper). Elements are arclengths divided by the longest arclength of
/// their side. The distance is the largest difference of two elements, where level i is weighted by 2^-i; elements are
/// added where one PAD is convex and the other concave. It does not depend on scale, rotation and place. Both PADs must
/// have been made with the same levels and delta_tau.
///
/// Only levels count that both PADs have, and each side is divided by the longest of these. Where the PADs have fewer than
/// 2 levels of a side in common, they cannot be compared, and the distance is infinite.
TESSERA_MATCHING_API double pad_distance(const Pad& p, const Pad& q);

}  // namespace tessera::matching
