// Tests whether a shape has a place on an empty canvas, on a coarse grid of positions and rotations. Used for messages
// that say what keeps pieces out, not for placing them.
#pragma once

#include "core/field/canvas.h"
#include "core/geometry/period.h"
#include "core/matching/pose_range.h"
#include "core/shape/outline.h"

namespace tessera {

struct EmptyRoom {
  const CanvasField& distance;  // of the canvas or of one of its regions (Canvas)
  Period period;
  float kept_px = 0;  // distance between a piece and the edge; negative: how far the piece may reach beyond
};

/// Whether a piece of this size may lie somewhere at one of the rotations. The test is too generous by up to about a
/// hundredth of the canvas' longer side: then it says yes although there is no place.
bool has_any_place(const Outline& outline, float scale_px, const DirectionRange& rotations, const EmptyRoom& room);

}  // namespace tessera
