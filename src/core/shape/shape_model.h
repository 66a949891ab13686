// The data of a library shape that matching and docking need: a small part of Shape, laid out for look-ups. Shape
// frame.
#pragma once

#include <array>
#include <vector>

#include "core/shape/model_sample.h"
#include "core/shape/shape.h"

namespace tessera {

inline constexpr int kBoundaryPoints = 192;  // fine set; every 2nd point is the medium set, every 6th the coarse one
inline constexpr int kMediumStride = 2;
inline constexpr int kCoarseStride = 6;
inline constexpr int kMaxInteriorPoints = 64;

/// The PADs of one smoothing level.
struct ModelLevel {
  int level = 0;  // index into kSmoothingLevels
  std::vector<ModelSample> samples;
};

struct ShapeModel {
  std::array<Vec2, kBoundaryPoints> boundary{};  // evenly over all curves, along each
  std::array<Vec2, kBoundaryPoints> tangent{};   // unit, interior on the left
  std::vector<Vec2> interior;                    // a coarse grid well inside, at most kMaxInteriorPoints
  Vec2 disc_centre;  // of the largest disc inside with its centre on a node of the shape's field
  float disc_radius = 0;
  float perimeter = 0;
  float radius = 0;
  ColourModel colour;
  std::vector<ModelLevel> levels;  // the levels that the job uses, coarse to fine
};

/// Makes the model of a `shape` that has outline, field and the wanted levels. If `pad` differs from the library's
/// parameters (`library_pad`), the pyramids are computed from the level curves.
ShapeModel make_shape_model(const Shape& shape, const PadParameters& library_pad, const PadParameters& pad,
                            const std::vector<int>& levels);

/// The smoothing levels that serve pieces of this range of scales (settings: pieces, tuning: target_sigma_px).
std::vector<int> levels_for_scales(float min_scale_px, float max_scale_px, float target_sigma_px);

inline constexpr float kLevelSliver = 1.1f;  // below this a level at the end of the scales is not worth its PADs
inline constexpr float kLevelSlack = 1.05f;  // a level serves its octave and this factor beyond

struct ScaleRange {
  float low;
  float high;
};
/// The scales, px, at which a level agrees with a target smoothed by target_sigma_px: half an octave in both
/// directions.
ScaleRange level_scales(int level, float target_sigma_px);

}  // namespace tessera
