// Dockings: (target sample, shape sample) and the similarity that this pair implies (paper section 3.3), with the early
// reject. kernels/docking.cl computes the same for many at once, bit for bit.
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

/// A larger key is better. Ties go by shape, then by source: a total order that does not depend on how the library is
/// divided.
struct Docking {
  std::uint32_t sample = 0;  // index among the request's target samples
  ShapeId shape{};
  /// PAD docking: index of the shape's PAD, counted over the levels in use. Tangent docking: kTangentSource + draw.
  std::uint32_t source = 0;
  std::uint32_t stance = 0;  // index in the context's StanceTable; the pose lies in this stance
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
  std::uint32_t stance = 0;  // index in the stances given
  bool valid = false;
};

/// Aligns the key points of both pyramids by least squares, at the longest level whose residual is below
/// kAlignmentTolerance. Takes the stance whose pose fits best; among equals, the first. The result is invalid if no
/// stance fits or if the scale leaves `scales`. The paper aligns the ends of level 0 only; the ends of all matched
/// intervals average the noise away.
Alignment align_pyramids(const Keypoints& shape, const ArclengthPyramid& target, int levels, ScaleRange scales,
                         std::span<const Stance> stances);

/// The tangent docking number `draw` of a target sample: shape, stance, boundary point and log-uniform scale. It comes
/// from counter-based random bits with the key (seed, sample, pass, draw).
struct TangentDraw {
  bool drawn = false;  // false: no shape may stand
  ShapeId shape{};
  std::uint32_t stance = 0;      // index in the context's StanceTable
  std::uint32_t point_bits = 0;  // select one of the boundary points that qualify
  float scale_px = 0;
};
/// Draws from the deck, or from all open shapes if the deck is empty; each shape is equally likely. If `near` is not
/// empty, most draws take a shape from that list of similar colours instead. The nearer its colour, the more likely is
/// a shape.
TangentDraw draw_tangent(const MatchingContext& context, const TargetSample& sample, std::uint32_t draw,
                         std::span<const std::uint32_t> near = {}, const Deck& deck = {});

/// The boundary point that the draw docks. Points whose tangent implies a rotation in `docked_rotations` are equally
/// likely; kNoPoint if there is none.
inline constexpr int kNoPoint = -1;
int docked_point(const ShapeModel& shape, const TangentDraw& draw, const TargetSample& sample,
                 const DirectionRange& docked_rotations);
/// The pose that puts the boundary point on the sample and the tangent along the sample's tangent. The pose is then
/// turned and scaled into `poses` if necessary.
Similarity tangent_docking(const ShapeModel& shape, int boundary_point, float scale_px, const TargetSample& sample,
                           const PoseRange& poses);

/// The key of a docking that the early reject refuses.
inline constexpr float kRejectedDocking = -1;

/// Early reject on a few boundary and interior points; the key ranks the dockings that pass. A docking with a key below
/// kLeastDockingKey is rejected.
float docking_key(const ShapeModel& shape, const Similarity& canvas_from_shape, const FieldView& field,
                  float max_scale_px);

}  // namespace tessera
