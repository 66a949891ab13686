#include "core/deform/identity.h"

#include <algorithm>

#include "core/shape/level_curve.h"

namespace tessera {
namespace {

/// Finer detail is seen as texture, not as shape. It is also the smoothing of targets for pieces of 20 to 160 px.
constexpr float kSeen_px = 2.5f;

const SmoothingLevel& level_at(float scale_px) {
  const SmoothingLevel* best = &kSmoothingLevels.front();
  const auto off = [&](const SmoothingLevel& level) {
    const float ratio = level.sigma * scale_px / kSeen_px;
    return std::max(ratio, 1 / ratio);
  };
  for (const SmoothingLevel& level : kSmoothingLevels) {
    if (off(level) < off(*best)) best = &level;
  }
  return *best;
}

}  // namespace

ShapeIdentity::ShapeIdentity(const Shape& shape, float scale_px, const PadParameters& pad) : pad_(pad) {
  const SmoothingLevel& level = level_at(scale_px);
  const LevelCurve curve = make_level_curve(shape.outline.curves.front(), level, pad);
  sigma_ = level.sigma;
  smooth_ = curve.points;
  for (const ArclengthPyramid& pyramid : curve.samples) samples_.push_back(make_pad(pyramid, pad.levels));
}

float ShapeIdentity::pad_distance(const Warp& warp) const {
  std::vector<Vec2> deformed;
  deformed.reserve(smooth_.size());
  for (const Vec2 p : smooth_) deformed.push_back(warp.apply(p));
  const std::vector<ArclengthPyramid> pyramids = sample_pyramids(deformed, sigma_, int(samples_.size()), pad_);
  double sum = 0;
  for (std::size_t j = 0; j < samples_.size(); ++j) {
    sum += double(tessera::pad_distance(samples_[j], make_pad(pyramids[j], pad_.levels), pad_.levels));
  }
  return float(sum / double(samples_.size()));
}

}  // namespace tessera
