// The parts of a canvas that pictures show beside the pieces: its edge, the drawing in canvas.keep_out, and the ground.
#pragma once

#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"
#include "job/canvas/canvas_edge.h"
#include "job/job_file.h"
#include "layers/ground_tile.h"
#include "layers/keep_out_drawing.h"

namespace tessera {

struct CanvasDrawing {
  CanvasEdge edge;
  KeepOutDrawing keep_out;
  GroundTile ground;
};

/// Limits for drawing the canvas' files when its pictures are made. Each drawing may take three times as long as in
/// check_canvas_drawing(), so that a file that passed before the run does not fail after it on a busy machine.
DrawerSettings canvas_picture_settings(const CanvasSpec& spec, const OutputSpec& output);

/// Draws the files. `output` is that of the pictures (on_paper). Throws InputError where a file cannot be read or drawn,
/// and DrawingStopped.
CanvasDrawing draw_canvas(const CanvasSpec& spec, const OutputSpec& output, const Canvas& canvas, Drawers& drawers);

/// Draws, before a long run, all files that draw_canvas() will draw, in the same size. Throws InputError that names key,
/// file and reason where one cannot be drawn, and EnvironmentError where the drawing program is missing.
void check_canvas_drawing(const CanvasSpec& spec, const OutputSpec& output, const Canvas& canvas,
                          double seconds = DrawerSettings{}.seconds_per_drawing);

}  // namespace tessera
