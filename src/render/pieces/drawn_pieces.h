// The pieces of a collage as its pictures show them: on a seamless canvas a piece that crosses a seam appears at both ends.
#pragma once

#include <cstddef>
#include <vector>

#include "render/pieces/shape_artworks.h"
#include "result/collage_files.h"

namespace tessera {

struct DrawnPiece {
  Placement placement;
  std::size_t piece = 0;  // its number in the collage
};

/// The placements in their order, each at all of its images that touch the canvas.
std::vector<DrawnPiece> drawn_pieces(const CollageReport& report, const ShapeArtworks& artworks);

}  // namespace tessera
