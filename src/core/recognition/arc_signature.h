// How an arc of a curve runs, whatever its place, rotation and size. A PAD measures arclengths by how much the curve has
// turned, and so it knows little of straight lines, and noise turns a curve without end; an arc is cut by its length.
// Signatures have the form of a PAD's bytes, so that the same index and search serve both.
#pragma once

#include <array>
#include <optional>

#include "core/geometry/vec2.h"
#include "core/pad/pad_search.h"

namespace tessera {

/// Lengths of arcs are half an octave apart on one side of a comparison, and a quarter on the other one, where the scale is
/// unknown.
inline constexpr float kArcStep = 1.41421356f;
inline constexpr float kFineArcStep = 1.18920712f;
/// The longest arc of a closed curve, in parts of it: a longer one comes back to where it began.
inline constexpr float kLongestOfClosed = 0.8f;

/// Points of an arc at even arclength, both ends among them.
inline constexpr int kArcPoints = 6;
using ArcPoints = std::array<Vec2, kArcPoints>;

/// The points in parts of the arc's length, about their mean, in the direction in which the arc runs; 1/2 is added to each
/// coordinate, so that all lie between 0 and 1. The last point is left out, as it follows from the mean.
using ArcSignature = std::array<float, kMaxPadElements>;

/// `length`: of the arc. None where the arc runs back to where it began, so that it has no direction.
std::optional<ArcSignature> arc_signature(const ArcPoints& points, float length);

/// The largest difference of a coordinate.
float arc_distance(const ArcSignature& a, const ArcSignature& b);

/// An entry of an index, of an arc of so many shape units. An arc without signature is never met.
PadBytes arc_bytes(const std::optional<ArcSignature>& signature, float length);

/// The target of a search in that index: arcs of the lengths between `least` and `most`, shape units.
PadTarget arc_target(const ArcSignature& signature, float least, float most);

}  // namespace tessera
