// The canvas' edge near one replacement window.
#pragma once

#include "core/field/free_field.h"
#include "core/geometry/polygon.h"
#include "core/replacing/replacement.h"
#include "core/settings/settings.h"

namespace tessera {

/// The distance to the edge of the canvas of `free`, as far around the window `box` as pieces of this job may reach. If
/// no point of the window is near the edge, the field has three nodes a side, all with a large distance.
EdgeField edge_around(const Box& box, const FreeField& free, const PieceSettings& pieces);

}  // namespace tessera
