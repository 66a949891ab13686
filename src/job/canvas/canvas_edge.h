// The edge of the canvas and of its regions for pictures: finer than the field in which pieces are placed.
#pragma once

#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"
#include "core/geometry/grid.h"
#include "core/geometry/vec2.h"
#include "job/job_file.h"

namespace tessera {

/// A part of a canvas with one colour beneath the pieces.
struct Ground {
  std::vector<std::vector<Vec2>> curves;  // closed, in canvas px, to be filled even-odd
  std::string colour;                     // "#rrggbb"; empty: the canvas' background (OutputSpec::background)
};

/// The outlines that pictures show of a canvas file.
struct CanvasEdge {
  std::vector<std::vector<Vec2>> curves;  // closed, in canvas px, to be filled even-odd; none: the whole canvas
  std::vector<Ground> grounds;            // drawn in this order, cut off at the edge; mostly none
};

/// The edge of what load_canvas (canvas_file.h) fills. It is traced in the page drawn at 4096 px or more along its
/// longest side, and lies within a quarter of a px of that page. Where regions have backgrounds it also gives the
/// grounds of all regions. Each ground reaches some px beneath those after it, so that no gap shows between them.
/// Errors as load_canvas.
CanvasEdge canvas_edge(const CanvasSpec& spec, Drawers& drawers);

/// Draws the canvas file once with the size that canvas_edge will use, to find errors early. Errors as canvas_edge.
void check_canvas_edge(const CanvasSpec& spec, const Canvas& canvas, Drawers& drawers);

/// Closed curves in canvas px round the area with a coverage of at least one half. A px of the page is `canvas_px`
/// wide.
std::vector<std::vector<Vec2>> traced_edge(Grid<float> coverage, float canvas_px);

}  // namespace tessera
