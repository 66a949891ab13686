// The edge of the canvas, and of its regions, as pictures show them: finer than the field that pieces are placed by.
#pragma once

#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"
#include "core/geometry/grid.h"
#include "core/geometry/vec2.h"
#include "job/job_file.h"

namespace tessera {

/// The part of a canvas that has one colour beneath the pieces.
struct Ground {
  std::vector<std::vector<Vec2>> curves;  // closed, in canvas px, to be filled even-odd
  std::string colour;                     // "#rrggbb"; empty: the canvas' own (OutputSpec::background)
};

/// What pictures show of a canvas file.
struct CanvasEdge {
  std::vector<std::vector<Vec2>> curves;  // closed, in canvas px, to be filled even-odd; none: the whole canvas
  std::vector<Ground> grounds;            // laid over each other within the edge, beyond which they reach; mostly none
};

/// The edge of what load_canvas (canvas_file.h) fills, within a quarter of a px of the page that it is drawn on, traced
/// at 4096 px or more along the page's longest side; and where regions have backgrounds, the grounds of all regions,
/// each of which goes on for some px beneath those after it, so that no gap shows between them. Errors as load_canvas.
CanvasEdge canvas_edge(const CanvasSpec& spec, Drawers& drawers);

/// Draws the file of a canvas from load_canvas as large as canvas_edge will. Errors as canvas_edge.
void check_canvas_edge(const CanvasSpec& spec, const Canvas& canvas, Drawers& drawers);

/// Closed curves in canvas px round what is covered half or more, of a page whose px are `canvas_px` wide.
std::vector<std::vector<Vec2>> traced_edge(Grid<float> coverage, float canvas_px);

}  // namespace tessera
