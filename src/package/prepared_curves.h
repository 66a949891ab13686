// Curves as the core computes with them. Its numbers are floats, and its limits are those of pixels: curves of any unit
// come in a frame of their own, in which they are as large as on a drawn page.
#pragma once

#include <vector>

#include "core/geometry/similarity.h"
#include "core/recognition/curve.h"
#include "tessera/matching/outline.h"

namespace tessera::matching {

/// Longer side of the box round all curves in their prepared frame, as that of read_drawn_curves().
inline constexpr double kPreparedExtent = 1024;
/// The narrowest smoothing in the prepared frame where the outline names none: of a clean silhouette's pixels.
inline constexpr double kDefaultSigma = 1.5;
/// Narrower ones change nothing, and cost time.
inline constexpr double kLeastSigma = 1e-3;

struct PreparedCurves {
  std::vector<tessera::Curve> curves;
  float least_sigma = 0;
  Similarity own_from_prepared;  // does not turn

  double own(double prepared_length) const { return prepared_length * own_from_prepared.a; }
  double prepared(double own_length) const { return own_length / own_from_prepared.a; }
};

/// Throws Error as check() does.
PreparedCurves prepared_curves(const Outline& outline);

inline Similarity to_public(const tessera::Similarity& s) { return {s.a, s.b, s.tx, s.ty}; }
inline Point to_public(Vec2 p) { return {p.x, p.y}; }

}  // namespace tessera::matching
