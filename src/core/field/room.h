// The room where pieces lay that were taken out of a collage: all that is filled anew where the rest is to stay.
#pragma once

#include <vector>

#include "core/field/canvas.h"
#include "core/geometry/polygon.h"
#include "core/geometry/similarity.h"

namespace tessera {

struct PieceThatLay {
  const Outline* outline = nullptr;
  Similarity canvas_from_shape;
};

/// Makes that room, and up to `beyond_px` around it, all that is filled of each of the canvas' regions; of one, if it
/// has none. The canvas itself stays as it is. Away from the room the regions' distance is -1, whatever lies between.
void fill_only_where_they_lay(const std::vector<PieceThatLay>& pieces, float beyond_px, Canvas& canvas);

}  // namespace tessera
