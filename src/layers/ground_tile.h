// The background under the pieces: the picture of output.ground repeated in tiles (mortar, sand, cloth), or the picture
// that the pieces show. The latter may also be drawn over the pieces (shown_picture.h).
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"
#include "job/job_file.h"

namespace tessera {

struct GroundTile {
  cv::Mat page;         // premultiplied BGRA; empty: no background
  cv::Size2d size_px;   // of a tile, in canvas px; the first tile lies in the canvas' upper left corner
  bool repeats = true;  // false: one tile covers the canvas, and its edges need not fit together
  std::string svg;      // the same as an SVG element; its page is svg_size large, in its own units
  cv::Size2d svg_size;
};

/// Width and height of a tile in canvas px: `width_px` wide (0: as wide as the drawing), with the drawing's aspect
/// ratio, and at least 1 px each. On a seamless canvas width and height are changed a little, so that a whole number of
/// tiles fits into the period.
cv::Size2d tile_size_px(cv::Size2d drawing, double width_px, const Canvas& canvas);

/// The tile of output.ground, with enough pixels for the pictures of that output. Throws InputError, which names the
/// key, where the file cannot be read or drawn, and DrawingStopped.
GroundTile draw_ground(const OutputSpec& output, const Canvas& canvas, Drawers& drawers);

}  // namespace tessera
