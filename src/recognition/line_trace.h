// Traces lines of pixels that are one pixel wide into polylines.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/grid.h"
#include "core/recognition/curve.h"

namespace tessera {

/// The lines of thinned() (thinning.h) as curves, in px; the middle of pixel (0, 0) is (0.5, 0.5). Lines are cut where they
/// meet: each branch is an open curve. A line that meets no other and returns to its start is a closed curve with its
/// interior on the left. A branch with a free end is dropped where it is shorter than the width of the drawn line at its
/// junction, because thinning makes such spurs at corners. `half_width_px`: half the width of the drawn line, at its
/// middle.
std::vector<Curve> traced_lines(const Grid<std::uint8_t>& thin, const Grid<float>& half_width_px);

}  // namespace tessera
