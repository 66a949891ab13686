// Draws the shadow that all pieces together cast on what lies below them.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "render/pieces/cairo_paint.h"
#include "result/collage_files.h"

namespace tessera {

class Shadow {
 public:
  /// `report` must outlive it. Without OutputSpec::shadow_strength it draws nothing.
  Shadow(const CollageReport& report, const cv::Size& picture_px);

  /// Darkens rows of the picture from row `top` on (BGR, or premultiplied BGRA). Rows do not depend on each other.
  void draw(int top, cv::Mat rows) const;

 private:
  struct Caster {
    PlacedCurves coarse;  // px of the coarse picture
    cv::Rect reach;
  };

  cv::Mat blurred(const cv::Rect& coarse_window) const;

  double strength_ = 0;
  int coarseness_ = 1;  // px of the picture for one px of the coarse picture, which is blurred
  double blur_px_ = 0;  // px of the coarse picture
  std::vector<Caster> casters_;
};

}  // namespace tessera
