// Which pieces of a result a user means who draws over its picture: a rectangle, or a scribble.
#pragma once

#include <string>
#include <vector>

#include "core/collage/judged_piece.h"
#include "core/field/canvas.h"
#include "core/geometry/polygon.h"
#include "io/result/placed_pieces.h"

namespace tessera::io {

/// Places of those whose centre lies in the box, canvas px.
std::vector<int> pieces_in(const Box& box, const std::vector<PlacedPiece>& pieces);

/// The cells of the canvas, two or one to a px both ways, that the drawing in the file marks with a half or more: it is
/// laid over the canvas, whose aspect it has. Read as canvas.file is. Throws InputError that begins with `option` and
/// the file where it is no artwork, has another aspect, or shows nothing.
Grid<float> erasing_mask(const std::string& file, const std::string& option, const Canvas& canvas);

/// Places of those that the mask touches: 4 px² of them, or all of a smaller one.
std::vector<int> pieces_under(const Grid<float>& mask, const std::vector<JudgedPiece>& pieces, const Canvas& canvas);

}  // namespace tessera::io
