// Brings curves into a frame for the core, whose numbers are floats and whose limits are those of pixels. Curves of any
// unit are scaled there to the size of a drawn page.
#pragma once

#include <vector>

#include "core/geometry/similarity.h"
#include "core/recognition/curve.h"
#include "tessera/matching/outline.h"

namespace tessera::matching {

/// Longer side of the bounding box of all curves in the prepared frame, the same as that of read_drawn_curves().
inline constexpr double kPreparedExtent = 1024;
/// Narrowest smoothing in the prepared frame where the outline gives none: right for the pixels of a clean silhouette.
inline constexpr double kDefaultSigma = 1.5;
/// Narrower smoothing changes nothing and costs time.
inline constexpr double kLeastSigma = 1e-3;

struct PreparedCurves {
  std::vector<tessera::Curve> curves;
  float least_sigma = 0;
  Similarity own_from_prepared;  // does not turn

  double own(double prepared_length) const { return prepared_length * own_from_prepared.a; }
  double prepared(double own_length) const { return own_length / own_from_prepared.a; }
};

/// Brings the curves into the prepared frame. Throws Error as check() does.
PreparedCurves prepared_curves(const Outline& outline);

inline Similarity to_public(const tessera::Similarity& s) { return {s.a, s.b, s.tx, s.ty}; }
inline Point to_public(Vec2 p) { return {p.x, p.y}; }

}  // namespace tessera::matching
