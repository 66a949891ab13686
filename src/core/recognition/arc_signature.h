// Signatures of arcs: the course of an arc, independent of its place, rotation and size. A PAD measures arclengths by
// the turning of the curve. So it tells little about straight lines, and noise adds turning without limit; an arc is
// cut by its length instead. Signatures have the form of a PAD's bytes, so that the same index and search serve both.
#pragma once

#include <array>
#include <optional>

#include "core/geometry/vec2.h"
#include "core/pad/pad_search.h"

namespace tessera {

/// Ratios of successive lengths of arcs: half an octave on one side of a comparison, and a quarter on the other side if
/// the scale is unknown.
inline constexpr float kArcStep = 1.41421356f;
inline constexpr float kFineArcStep = 1.18920712f;
/// The longest arc of a closed curve, as a fraction of its length: a longer one returns to its beginning.
inline constexpr float kLongestOfClosed = 0.8f;

/// The number of points of an arc, at even arclength and including both ends.
inline constexpr int kArcPoints = 6;
using ArcPoints = std::array<Vec2, kArcPoints>;

/// The points in units of the arc's length, relative to their mean, in the direction of the arc. Each coordinate has
/// 1/2 added, so that all lie between 0 and 1. The last point is left out, as it follows from the mean.
using ArcSignature = std::array<float, kMaxPadElements>;

/// The signature of an arc of this length. Empty if the arc returns to its beginning, so that it has no direction.
std::optional<ArcSignature> arc_signature(const ArcPoints& points, float length);

/// The largest difference of a coordinate.
float arc_distance(const ArcSignature& a, const ArcSignature& b);

/// The index entry of an arc of this length (shape units). A search never finds an arc without signature.
PadBytes arc_bytes(const std::optional<ArcSignature>& signature, float length);

/// The target of a search in that index: arcs with lengths between `least` and `most`, shape units.
PadTarget arc_target(const ArcSignature& signature, float least, float most);

}  // namespace tessera
