// The differences in style between the pieces of a collage.
#pragma once

#include <optional>
#include <vector>

#include "core/quality/judged_piece.h"

namespace tessera {

/// The mean style distance (core/style/style_features.h) of two pieces, each pair weighted by the product of their
/// areas. Copies of a shape have distance 0. Empty if the style of a piece is unknown or if there are fewer than two
/// pieces.
std::optional<double> mean_style_distance(const std::vector<JudgedPiece>& pieces);

}  // namespace tessera
