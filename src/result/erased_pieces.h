// Finds the pieces that a user means by a rectangle or by painting over a result's picture.
#pragma once

#include <string>
#include <vector>

#include "core/field/canvas.h"
#include "core/geometry/polygon.h"
#include "core/quality/judged_piece.h"
#include "result/placed_pieces.h"

namespace tessera {

/// The places of the pieces whose centre lies in the box, canvas px.
std::vector<int> pieces_in(const Box& box, const std::vector<PlacedPiece>& pieces);

struct ErasingMask {
  Grid<float> cells;       // of the canvas, one or two to a px in each direction; marked: 0.5 or more
  bool is_opaque = false;  // the file's page is opaque everywhere, so marks were found by their colours
};

/// The marks in the file, which is laid over the canvas and must have its aspect. It is read like canvas.file. Where the
/// file mostly shows the same as `picture`, the result's own picture, somebody has painted over that: then only clear
/// differences are marks. Throws InputError that begins with `option` and the file, where the file is no artwork, has
/// another aspect, shows nothing, or is opaque without a plain ground and no copy of the picture.
ErasingMask erasing_mask(const std::string& file, const std::string& option, const Canvas& canvas,
                         const std::string& picture = {});

/// The places of the pieces that the mask touches: at least 4 px² of a piece, or all of a smaller one, and at least the
/// part `least_part` of each.
std::vector<int> pieces_under(const Grid<float>& mask, const std::vector<JudgedPiece>& pieces, const Canvas& canvas,
                              double least_part = 0);

}  // namespace tessera
