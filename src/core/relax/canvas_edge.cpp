#include "core/relax/canvas_edge.h"

#include <algorithm>

namespace tessera {
namespace {

/// So much before the last node look-ups are on the grid, however rounding takes them: to 100,000 px.
constexpr float kBeforeTheLastNode_px = 0.01f;

}  // namespace

FieldSample CanvasEdge::at(Vec2 canvas_px) const {
  const FieldView field = free_.view();
  const Vec2 p = period().wrapped(canvas_px);
  const Vec2 last{float(field.width - 1) - kBeforeTheLastNode_px, float(field.height - 1) - kBeforeTheLastNode_px};
  const Vec2 nearest{std::clamp(p.x, field.origin.x, field.origin.x + last.x),
                     std::clamp(p.y, field.origin.y, field.origin.y + last.y)};
  FieldSample sample = free_.canvas_sample(nearest);
  if (nearest == p) return sample;
  const Vec2 beyond = p - nearest;
  const float way = norm(beyond);
  if (beyond.x != 0) sample.gradient.x = 0;
  if (beyond.y != 0) sample.gradient.y = 0;
  return {sample.value - way, sample.gradient - beyond * (1 / way)};
}

}  // namespace tessera
