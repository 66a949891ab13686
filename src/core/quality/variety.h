// The visible variety of shapes in a collage. The eye notices large copies most.
#pragma once

#include <optional>
#include <vector>

#include "core/quality/judged_piece.h"

namespace tessera {

/// The number of shapes with equal shares of the area that would repeat as much as these pieces do. It is e to the
/// entropy of the shapes' shares of the area of all pieces with a name. From 1 to the number of different shapes. Empty
/// if no piece has a name.
std::optional<double> effective_shapes(const std::vector<JudgedPiece>& pieces);

}  // namespace tessera
