// The drawing of canvas.keep_out (letters, a logo) as part of the pictures.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"
#include "job/job_file.h"

namespace tessera {

struct KeepOutDrawing {
  cv::Rect2d place_px;  // of the drawing's page, in canvas px
  cv::Mat page;         // straight BGRA; empty: no drawing
  std::string svg;      // the same as an SVG element; its page is svg_width wide, in its own units
  double svg_width = 0;
  /// Closed curves in canvas px, even-odd, round what is drawn where the page has a background of its own. Empty: it
  /// has no background.
  std::vector<std::vector<Vec2>> clip;
};

/// Draws the file `path` (canvas.keep_out; empty: none) with enough pixels for the pictures of that output, up to the
/// largest page that a drawer draws. Throws InputError where it cannot be drawn, and DrawingStopped.
KeepOutDrawing draw_keep_out(const std::string& path, const OutputSpec& output, const Canvas& canvas, Drawers& drawers);

}  // namespace tessera
