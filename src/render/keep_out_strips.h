// Draws the drawing in canvas.keep_out as pixels, strip by strip.
#pragma once

#include <opencv2/core.hpp>

#include "layers/keep_out_drawing.h"
#include "render/pieces/piece_drawing.h"
#include "render/pieces/sprite.h"

namespace tessera {

class KeepOutStrips {
 public:
  /// `drawing` must outlive it. `picture_px`: px of the picture for one px of the canvas.
  KeepOutStrips(const KeepOutDrawing& drawing, double picture_px, cv::Size picture);

  /// Lays the drawing over rows of the picture (BGR, or premultiplied BGRA). `top`: the first row, a multiple of
  /// kStripRows.
  void draw(int top, cv::Mat rows) const;

 private:
  const KeepOutDrawing& drawing_;
  double picture_px_;
  PieceDrawing page_;  // its place in the picture
  Sprite sprite_;
};

}  // namespace tessera
