#include "bench/baselines/random_filling.h"

#include <cmath>
#include <random>

#include "core/base/stopwatch.h"
#include "core/field/free_field.h"
#include "core/matching/refinement.h"
#include "core/settings/tuning.h"

namespace tessera::bench {
namespace {

constexpr int kBisections = 10;  // of the range of scales

/// The similarity resized about its own origin.
Similarity resized(const Similarity& s, float factor) { return {s.a * factor, s.b * factor, s.tx, s.ty}; }

/// The largest scale without overlap; `pose` has scale 1. Zero where not even the smallest piece fits.
float largest_scale_px(const Similarity& pose, const ShapeModel& model, const FieldView& field,
                       const PieceSettings& pieces) {
  const auto fits = [&](float scale_px) {
    return depth_px(resized(pose, scale_px), model, field) <= hard_depth_px(pieces);
  };
  float fitting_px = pieces.min_scale_px;
  float too_large_px = pieces.max_scale_px;
  if (!fits(fitting_px)) return 0;
  if (fits(too_large_px)) return too_large_px;
  for (int i = 0; i < kBisections; ++i) {
    const float middle_px = 0.5f * (fitting_px + too_large_px);
    (fits(middle_px) ? fitting_px : too_large_px) = middle_px;
  }
  return fitting_px;
}

}  // namespace

std::vector<Placement> fill_at_random(const Canvas& canvas, const CollageSettings& settings, ShapeSource& shapes,
                                      std::uint32_t shape_count, double seconds) {
  std::mt19937_64 bits(settings.seed);
  const auto uniform = [&](float low, float high) {
    return low + (high - low) * (float(bits() >> 40) / float(1 << 24));
  };
  const PieceSettings& pieces = settings.pieces;
  FreeField free(canvas, pieces);
  std::vector<Placement> placements;
  const Stopwatch watch;
  while (watch.seconds() < seconds) {
    const Vec2 place{uniform(0, float(canvas.width_px)), uniform(0, float(canvas.height_px))};
    const float angle_rad = uniform(pieces.min_rotation_rad, pieces.max_rotation_rad);
    const ShapeId shape{std::uint32_t(bits() % shape_count)};
    if (field_value(free.view(), place) <= 0) continue;
    const Similarity pose{std::cos(angle_rad), std::sin(angle_rad), place.x, place.y};
    const float scale_px = largest_scale_px(pose, shapes.model(shape), free.view(), pieces);
    if (scale_px == 0) continue;
    placements.push_back({shape, resized(pose, scale_px), 0, 0});
    free.stamp(shapes.shape(shape), placements.back().canvas_from_shape);
  }
  return placements;
}

}  // namespace tessera::bench
