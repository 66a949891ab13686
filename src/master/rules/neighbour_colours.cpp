#include "master/rules/neighbour_colours.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/colour/ciede2000.h"
#include "core/colour/fading.h"
#include "core/settings/tuning.h"

namespace tessera::master {
namespace {

/// The square in which a piece looks for neighbours. Squares of neighbours overlap.
Window surroundings(const Similarity& canvas_from_shape, Vec2 moved_px = {}) {
  const float reach_px = kNeighbourReach * canvas_from_shape.scale();
  const Vec2 centre = canvas_from_shape.translation() + moved_px;
  const auto node = [](float v) { return int(std::floor(v)); };
  return {node(centre.x - reach_px), node(centre.y - reach_px), node(centre.x + reach_px) + 1,
          node(centre.y + reach_px) + 1};
}

}  // namespace

NeighbourColours::NeighbourColours(const ColourWish& wish, const Period& period) : wish_(wish), period_(period) {}

void NeighbourColours::add(const Placement& placement) {
  if (!matters()) return;
  for (const Vec2 offset : period_.offsets()) {
    TileIndex::Region region;
    region.add(surroundings(placement.canvas_from_shape, offset));
    for (const TileIndex::Tile tile : std::move(region).tiles()) index_.insert(tile, std::uint32_t(placed_.size()));
  }
  placed_.push_back(placement);
}

void NeighbourColours::forget_placements() {
  placed_.clear();
  index_ = {};
}

float NeighbourColours::worth(ShapeId shape, const Similarity& canvas_from_shape) const {
  if (!matters()) return 1;
  const Vec2 centre = canvas_from_shape.translation();
  float least_welcome = 0;  // 0 to 1
  index_.each(surroundings(canvas_from_shape), [&](std::uint32_t other) {
    const Similarity& pose = placed_[other].canvas_from_shape;
    const float near_px = kNeighbourReach * (pose.scale() + canvas_from_shape.scale());
    const Vec2 apart = period_.nearest(pose.translation(), centre) - centre;
    if (dot(apart, apart) >= near_px * near_px) return;
    const float difference = std::min(kOtherColour, ciede2000(colour_of(shape), colour_of(placed_[other].shape)));
    const float unlike = difference / kOtherColour;
    least_welcome = std::max(least_welcome, wish_.neighbours > 0 ? unlike : 1 - unlike);
  });
  return faded(kNeighbourFading * std::abs(wish_.neighbours) * least_welcome);
}

}  // namespace tessera::master
