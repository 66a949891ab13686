// Which pieces of a result a user means who draws over its picture: a rectangle, or a scribble.
#pragma once

#include <string>
#include <vector>

#include "core/field/canvas.h"
#include "core/geometry/polygon.h"
#include "core/quality/judged_piece.h"
#include "result/placed_pieces.h"

namespace tessera {

/// Places of those whose centre lies in the box, canvas px.
std::vector<int> pieces_in(const Box& box, const std::vector<PlacedPiece>& pieces);

struct ErasingMask {
  Grid<float> cells;       // of the canvas, two or one to a px both ways; marked: a half or more
  bool is_opaque = false;  // the file's page is, everywhere: what of it is marked was told by its colours
};

/// What the drawing in the file marks, which is laid over the canvas, whose aspect it has. Read as canvas.file is.
/// Where it shows for the most part what `picture` does, the result's own, somebody has painted over that: marked is
/// only what differs clearly. Throws InputError that begins with `option` and the file where it is no artwork, has
/// another aspect, shows nothing, or is opaque on no plain ground and no copy of the picture.
ErasingMask erasing_mask(const std::string& file, const std::string& option, const Canvas& canvas,
                         const std::string& picture = {});

/// Places of those that the mask touches: 4 px² of them, or all of a smaller one; and no less than this part of each.
std::vector<int> pieces_under(const Grid<float>& mask, const std::vector<JudgedPiece>& pieces, const Canvas& canvas,
                              double least_part = 0);

}  // namespace tessera
