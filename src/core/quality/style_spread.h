// How far the pieces of a collage are in style from each other.
#pragma once

#include <optional>
#include <vector>

#include "core/quality/judged_piece.h"

namespace tessera {

/// The mean style distance (core/style/style_features.h) of two pieces, each pair by the product of their areas; copies
/// of a shape have none. Nothing where the style of a piece is not known, or there are no two.
std::optional<double> mean_style_distance(const std::vector<JudgedPiece>& pieces);

}  // namespace tessera
