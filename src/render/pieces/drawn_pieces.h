// The pieces of a collage as its pictures show them: on a seamless canvas one that crosses a seam is seen at both ends.
#pragma once

#include <cstddef>
#include <vector>

#include "render/pieces/shape_artworks.h"
#include "result/collage_files.h"

namespace tessera {

struct DrawnPiece {
  Placement placement;
  std::size_t piece = 0;  // among the collage's
};

/// The placements in their order, each at all of its images that touch the canvas, one after the other.
std::vector<DrawnPiece> drawn_pieces(const CollageReport& report, const ShapeArtworks& artworks);

}  // namespace tessera
