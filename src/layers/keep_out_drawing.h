// The drawing in canvas.keep_out as part of the pictures: letters, a logo.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"
#include "job/job_file.h"

namespace tessera {

struct KeepOutDrawing {
  cv::Rect2d place_px;  // of its page on the canvas, px of it
  cv::Mat page;         // straight BGRA; empty: there is none
  std::string svg;      // the same as an SVG element, its page svg_width wide in units of its own
  double svg_width = 0;
  /// Closed curves in canvas px, even-odd, where the page has a background, which is not drawn. Empty: it has none.
  std::vector<std::vector<Vec2>> clip;
};

/// Of the file `path` (canvas.keep_out; empty: none), drawn fine enough for pictures of that output, up to the largest
/// page that is drawn. Throws InputError where it cannot be drawn, and DrawingStopped.
KeepOutDrawing draw_keep_out(const std::string& path, const OutputSpec& output, const Canvas& canvas, Drawers& drawers);

}  // namespace tessera
