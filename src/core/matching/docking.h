// Dockings: (target sample, shape sample) and the similarity that it implies (paper section 3.3), with the early
// reject. kernels/docking.cl does the same for many at once, bit for bit.
#pragma once

#include <cstdint>
#include <span>

#include "core/field/field_lookup.h"
#include "core/field/target_sample.h"
#include "core/matching/deck.h"
#include "core/matching/matching_context.h"
#include "core/shape/shape_id.h"
#include "core/shape/shape_model.h"

namespace tessera {

/// A larger key is better; ties go by shape, then source: a total order that no partition of the library changes.
struct Docking {
  std::uint32_t sample = 0;  // place among the request's target samples
  ShapeId shape{};
  /// PAD docking: index of the shape's PAD, counted over the levels in use. Tangent docking: kTangentSource + draw.
  std::uint32_t source = 0;
  std::uint32_t stance = 0;  // of the context's: the pose is one of it
  float key = 0;
  Similarity canvas_from_shape;

  friend bool operator==(const Docking&, const Docking&) = default;
};

inline constexpr std::uint32_t kTangentSource = 1u << 31;

inline bool docks_better(const Docking& a, const Docking& b) {
  if (a.key != b.key) return a.key > b.key;
  if (a.shape != b.shape) return a.shape < b.shape;
  return a.source < b.source;
}

struct Alignment {
  Similarity canvas_from_shape;
  std::uint32_t stance = 0;  // place among those given
  bool valid = false;
};

/// Aligns the key points of both pyramids in the least squares sense, at the longest level at which they agree within
/// kAlignmentTolerance, by the pose of `stances` that fits them best (of equals that of the first); invalid where none
/// does or the scale leaves `scales`. The paper aligns the ends of level 0 only; using all ends of the matched
/// intervals averages the noise away.
Alignment align_pyramids(const Keypoints& shape, const ArclengthPyramid& target, int levels, ScaleRange scales,
                         std::span<const Stance> stances);

/// The tangent docking number `draw` of a target sample: shape, stance, boundary point and log-uniform scale from
/// counter-based random bits keyed by (seed, sample, pass, draw). Any shape that may stand is as likely.
struct TangentDraw {
  bool drawn = false;  // false: no shape may stand
  ShapeId shape{};
  std::uint32_t stance = 0;      // of the context's
  std::uint32_t point_bits = 0;  // choose among the boundary points that come into question
  float scale_px = 0;
};
/// Of the shapes that may stand, or those of a deck. Where there is a list of `near` colours, most draws take one of
/// those shapes, the nearer the more likely.
TangentDraw draw_tangent(const MatchingContext& context, const TargetSample& sample, std::uint32_t draw,
                         std::span<const std::uint32_t> near = {}, const Deck& deck = {});

/// The boundary point that the draw docks: any of those whose tangent implies one of docked_rotations is as likely;
/// kNoPoint where there is none.
inline constexpr int kNoPoint = -1;
int docked_point(const ShapeModel& shape, const TangentDraw& draw, const TargetSample& sample,
                 const DirectionRange& docked_rotations);
/// The pose that puts the point on the sample and its tangent along the sample's, but for the turn that brings it into
/// `poses`.
Similarity tangent_docking(const ShapeModel& shape, int boundary_point, float scale_px, const TargetSample& sample,
                           const PoseRange& poses);

/// The key of a docking that is not possible at all.
inline constexpr float kRejectedDocking = -1;

/// Early reject on a few boundary and interior points; the key ranks what is left. A key below kLeastDockingKey means
/// that it is rejected.
float docking_key(const ShapeModel& shape, const Similarity& canvas_from_shape, const FieldView& field,
                  float max_scale_px);

}  // namespace tessera
