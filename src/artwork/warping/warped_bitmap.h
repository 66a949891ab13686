// Bitmaps within a drawing, deformed with their piece's outline.
#pragma once

#include <cairo.h>

#include <opencv2/core.hpp>

#include "core/deform/warp.h"

namespace tessera {

/// A bitmap that lies on a page, a pixel a unit of its own frame.
struct PageBitmap {
  cv::Mat bgra;  // straight, CV_8UC4
  cairo_matrix_t page_from_bitmap;
};

/// What is shown of a bitmap after the deformation: the box of the page that it fills. Empty where nothing is to be seen.
struct WarpedBitmap {
  cv::Mat bgra;  // straight
  cv::Rect2d box;
};

/// The part of the bitmap that lies on the page, (0, 0) to `page`, deformed. With `goes_on` its pixels along the edge go on
/// beyond it by a little: a clip is to cut it. It has as many pixels as the bitmap has there, within limits. Throws
/// InputError where the warp's grid is too fine for it, or throws it too far.
WarpedBitmap warped_bitmap(const PageBitmap& bitmap, const Warp& page_warp, cv::Size2d page, bool goes_on);

}  // namespace tessera
