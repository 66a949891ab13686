// What pictures show below the pieces: the picture in output.ground in tiles (mortar, sand, cloth), or the one that the
// pieces show, which may lie over them, too (shown_picture.h).
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"
#include "job/job_file.h"

namespace tessera {

struct GroundTile {
  cv::Mat page;         // premultiplied BGRA; empty: there is none
  cv::Size2d size_px;   // of a tile, px of the canvas; the first one lies in its upper left corner
  bool repeats = true;  // else it covers the canvas, and its edges do not meet
  std::string svg;      // the same as an SVG element, its page as large as svg_size in units of its own
  cv::Size2d svg_size;
};

/// Width and height of a tile, px of the canvas: `width_px` wide (0: as wide as the drawing) with the drawing's
/// aspect, but at least 1 px each.
/// Where the canvas is seamless it becomes a little wider or narrower, or higher or lower, so that a whole number of
/// tiles fits into the period.
cv::Size2d tile_size_px(cv::Size2d drawing, double width_px, const Canvas& canvas);

/// That of output.ground, drawn fine enough for pictures of that output. Throws InputError, which names the key, where
/// the file cannot be read or drawn, and DrawingStopped.
GroundTile draw_ground(const OutputSpec& output, const Canvas& canvas, Drawers& drawers);

}  // namespace tessera
