// Whether a shape has a place on a canvas with nothing on it. It is looked for on a coarse grid of positions and rotations:
// for messages that say what keeps pieces out, and not for placing them.
#pragma once

#include "core/field/canvas.h"
#include "core/geometry/period.h"
#include "core/matching/pose_range.h"
#include "core/shape/outline.h"

namespace tessera {

struct EmptyRoom {
  const CanvasField& distance;  // of the canvas or of one of its regions (Canvas)
  Period period;
  float kept_px = 0;  // between a piece and the edge; negative: how far it may reach beyond
};

/// Whether a piece of that size may lie somewhere at one of the rotations. Within about a hundredth of the canvas' longer
/// side it says yes where there is no place.
bool has_any_place(const Outline& outline, float scale_px, const DirectionRange& rotations, const EmptyRoom& room);

}  // namespace tessera
