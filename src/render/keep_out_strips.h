// The drawing in canvas.keep_out as pixels, strip by strip.
#pragma once

#include <opencv2/core.hpp>

#include "layers/keep_out_drawing.h"
#include "render/pieces/piece_drawing.h"
#include "render/pieces/sprite.h"

namespace tessera {

class KeepOutStrips {
 public:
  /// `drawing` must outlive it; a px of the canvas has `picture_px` of the picture.
  KeepOutStrips(const KeepOutDrawing& drawing, double picture_px, cv::Size picture);

  /// Lays it over rows of the picture from row `top` on, a multiple of kStripRows: BGR, or premultiplied BGRA.
  void draw(int top, cv::Mat rows) const;

 private:
  const KeepOutDrawing& drawing_;
  double picture_px_;
  PieceDrawing page_;  // its place in the picture
  Sprite sprite_;
};

}  // namespace tessera
