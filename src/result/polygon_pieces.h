// Reads the pieces of a collage of any origin from the polygons of a GeoJSON file.
#pragma once

#include <string>
#include <vector>

#include "core/field/canvas.h"
#include "core/quality/judged_piece.h"

namespace tessera {

/// Coordinates are px of the canvas, y down. Rings may have either direction. Several polygons of a feature are one piece.
/// The scale of a piece is the square root of its area, whatever its properties say. Throws InputError that names the file,
/// the feature (from 0), what was found and what is allowed. It refuses rings that are not closed, enclose nothing, cross
/// themselves or each other, or lie in too many layers, and pieces so far beyond the canvas that they must belong to
/// another one. On a seamless canvas the centre of each piece is moved into the one period.
std::vector<JudgedPiece> read_polygon_pieces(const std::string& path, const Canvas& canvas);

}  // namespace tessera
