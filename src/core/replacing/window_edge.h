// The canvas' edge as the pieces of one replacement window feel it.
#pragma once

#include "core/field/free_field.h"
#include "core/geometry/polygon.h"
#include "core/replacing/replacement.h"
#include "core/settings/settings.h"

namespace tessera {

/// The distance to the edge of the canvas of `free`, as far round the window `box` as pieces of this job may reach.
/// Where no point of the window is near the edge, the field has three nodes a side, all of them far from it.
EdgeField edge_around(const Box& box, const FreeField& free, const PieceSettings& pieces);

}  // namespace tessera
