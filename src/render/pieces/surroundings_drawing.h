// Draws the photo round a piece that was cut out of it (Artwork::surroundings_png).
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "artwork/drawers/drawers.h"
#include "core/collage/placement.h"
#include "core/shape/shape.h"
#include "render/pieces/piece_drawing.h"
#include "render/pieces/sprite.h"

namespace tessera {

/// The surroundings of a piece as a drawing for draw_rows(). Its box is all that they cover, also outside the picture; the
/// slot is the caller's. `picture_px`: px of the picture for one px of the canvas. Empty where the shape has none, or where
/// their size is not that of the artwork and a margin, or beyond any picture.
std::optional<PieceDrawing> surroundings_drawing(const Placement& placement, const Shape& shape, double picture_px);

/// The pixels of a shape for which surroundings_drawing() gives a drawing; transparent where they are damaged. No side is
/// longer than PieceDrawing::sprite_side_px.
Sprite surroundings_sprite(const Artwork& artwork, Drawers& drawers);

}  // namespace tessera
