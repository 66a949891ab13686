// Applies a piece's warp to its drawing: to the page, or to a sprite.
#pragma once

#include "core/deform/warp.h"
#include "core/shape/shape.h"
#include "render/pieces/sprite.h"

namespace tessera {

/// `warp` in the artwork frame times `units_per_px`; for a mirror image, the warp of the drawing.
Warp warp_of_page(const Artwork& artwork, const Warp& warp, double units_per_px);

/// The deformed sprite, on a page that is `margin_px` larger on every side, artwork px.
Sprite warped_sprite(const Sprite& sprite, const Artwork& artwork, const Warp& warp, float margin_px);

}  // namespace tessera
