// Random filling: a collage without any matching.
#pragma once

#include <vector>

#include "core/collage/placement.h"
#include "core/field/canvas.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"

namespace tessera::bench {

/// Places pieces for `seconds`. Each is one of the first `shape_count` shapes at random, at a random place of the free
/// region, with a random rotation, as large as it fits without overlap.
std::vector<Placement> fill_at_random(const Canvas& canvas, const CollageSettings& settings, ShapeSource& shapes,
                                      std::uint32_t shape_count, double seconds);

}  // namespace tessera::bench
