// Measures how closely pieces fit: the fraction of their boundaries that runs along other pieces or along the canvas'
// edge.
#pragma once

#include <vector>

#include "core/field/canvas.h"
#include "core/quality/judged_piece.h"

namespace tessera {

/// Fraction (0..1) of the pieces' boundary length, holes included, within `reach_px` of the boundary of another piece
/// or of the canvas' edge. It is 0 without pieces.
double shared_boundary_fraction(const Canvas& canvas, const std::vector<JudgedPiece>& pieces, float reach_px);

/// For each point of the outlines, piece by piece and curve by curve: the distance to the nearest boundary of another piece
/// or to the canvas' edge, `reach_px` at most. Distances to pieces are rounded up by a quarter of a px at most.
std::vector<float> boundary_distances_px(const Canvas& canvas, const std::vector<JudgedPiece>& pieces, float reach_px);

}  // namespace tessera
