// Draws a collage in plain colours, for a look at it.
#pragma once

#include <string>
#include <vector>

#include "core/collage/placement.h"
#include "core/field/canvas.h"
#include "core/shape/shape.h"

namespace tessera::bench {

/// Outlines filled in alternating colours; the first placement, the seed, is grey. `shapes[i]` is library shape i.
std::string collage_svg(const Canvas& canvas, const std::vector<Placement>& placements,
                        const std::vector<Shape>& shapes);

/// Writes the same picture to `path`, a PNG. Throws EnvironmentError.
void write_collage_picture(const Canvas& canvas, const std::vector<Placement>& placements,
                           const std::vector<Shape>& shapes, const std::string& path);

}  // namespace tessera::bench
