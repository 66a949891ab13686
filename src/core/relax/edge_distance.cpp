#include "core/relax/edge_distance.h"

#include <algorithm>

namespace tessera {
namespace {

/// Look-ups are clamped this far before the last node, so that rounding cannot take them off the grid: enough for
/// 100,000 nodes.
constexpr float kBeforeTheLastNode = 0.01f;

}  // namespace

FieldSample EdgeDistance::at(Vec2 canvas_px) const {
  const Vec2 p = period_.wrapped(canvas_px) * (1 / node_px_);
  const Vec2 last{float(field_.width - 1) - kBeforeTheLastNode, float(field_.height - 1) - kBeforeTheLastNode};
  const Vec2 nearest{std::clamp(p.x, field_.origin.x, field_.origin.x + last.x),
                     std::clamp(p.y, field_.origin.y, field_.origin.y + last.y)};
  FieldSample sample = field_sample(field_, nearest);
  sample.value += add_px_;
  sample.gradient = sample.gradient * (1 / node_px_);
  if (nearest == p) return sample;
  const Vec2 beyond = p - nearest;
  const float way = norm(beyond);  // nodes
  if (beyond.x != 0) sample.gradient.x = 0;
  if (beyond.y != 0) sample.gradient.y = 0;
  return {sample.value - way * node_px_, sample.gradient - beyond * (1 / way)};
}

}  // namespace tessera
