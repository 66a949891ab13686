// The edge of the canvas as pictures show it: finer than the field that pieces are placed by.
#pragma once

#include <vector>

#include "core/geometry/grid.h"
#include "core/geometry/vec2.h"
#include "io/drawing/drawers.h"
#include "io/job/job_file.h"

namespace tessera::io {

/// Closed curves in canvas px, to be filled even-odd: the edge of what load_canvas (canvas_file.h) fills, within a quarter
/// of a canvas px, traced at 4096 px or more along the page's longest side. Without a file there are none: the whole
/// canvas is filled. Errors as load_canvas.
std::vector<std::vector<Vec2>> canvas_edge(const CanvasSpec& spec, Drawers& drawers);

/// Closed curves in canvas px round what is covered half or more, of a page whose px are `canvas_px` wide.
std::vector<std::vector<Vec2>> traced_edge(Grid<float> coverage, float canvas_px);

}  // namespace tessera::io
