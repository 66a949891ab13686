// Polylines along lines that are one pixel wide.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/grid.h"
#include "core/recognition/curve.h"

namespace tessera {

/// The lines of thinned() (thinning.h) as curves, in px; the middle of pixel (0, 0) is (0.5, 0.5). Where lines meet they
/// are cut: each branch is an open curve. A line that meets none and comes back to itself is a closed curve with its
/// interior on the left. Branches that end freely and are shorter than the drawn line is wide at their junction are
/// dropped: thinning makes such spurs at corners. `half_width_px`: of the drawn line, at its middle.
std::vector<Curve> traced_lines(const Grid<std::uint8_t>& thin, const Grid<float>& half_width_px);

}  // namespace tessera
