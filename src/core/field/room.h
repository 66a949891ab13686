// The room that pieces leave when they are taken out of a collage. Only this room is filled again if the rest must
// stay.
#pragma once

#include <vector>

#include "core/field/canvas.h"
#include "core/geometry/polygon.h"
#include "core/geometry/similarity.h"

namespace tessera {

struct RemovedPiece {
  const Outline* outline = nullptr;
  Similarity canvas_from_shape;
};

/// Limits each of the canvas' regions to that room and a rim of `beyond_px` around it. A canvas without regions gets
/// one. The canvas' own distance is unchanged. Away from the room the regions' distance is -1, whatever lies between.
void limit_regions_to_room(const std::vector<RemovedPiece>& pieces, float beyond_px, Canvas& canvas);

}  // namespace tessera
