// The pieces of a collage that anybody made, from the polygons of a GeoJSON file.
#pragma once

#include <string>
#include <vector>

#include "core/field/canvas.h"
#include "core/quality/judged_piece.h"

namespace tessera {

/// Coordinates are px of the canvas, y down. Outer rings and holes may run either way round; several polygons of a
/// feature are one piece. The scale of a piece is the square root of its area, whatever its properties say. Throws
/// InputError that names the file, the feature from 0, what was found and what is allowed: rings that are not closed,
/// enclose nothing, cross themselves or each other or lie in too many layers, and pieces that lie so far beyond the
/// canvas that it must be another one's. On a seamless canvas each piece comes back with its centre in the one period.
std::vector<JudgedPiece> read_polygon_pieces(const std::string& path, const Canvas& canvas);

}  // namespace tessera
