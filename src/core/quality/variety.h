// How rich in shapes a collage is to the eye, which goes by large copies.
#pragma once

#include <optional>
#include <vector>

#include "core/quality/judged_piece.h"

namespace tessera {

/// So many shapes, each with an equal share of the area, repeat themselves as much as these do: e to the entropy of the
/// shapes' shares of the area of all pieces that have a name. From 1 to the number of different shapes. Nothing where
/// no piece has a name.
std::optional<double> effective_shapes(const std::vector<JudgedPiece>& pieces);

}  // namespace tessera
