// Deforms bitmaps within a drawing together with their piece's outline.
#pragma once

#include <cairo.h>

#include <opencv2/core.hpp>

#include "core/deform/warp.h"

namespace tessera {

/// A bitmap on a page; in its own frame a pixel is one unit.
struct PageBitmap {
  cv::Mat bgra;  // straight, CV_8UC4
  cairo_matrix_t page_from_bitmap;
};

/// The visible part of a bitmap after the deformation, and the box of the page that it fills. Empty where nothing is
/// visible.
struct WarpedBitmap {
  cv::Mat bgra;  // straight
  cv::Rect2d box;
};

/// Deforms the part of the bitmap on the page, (0, 0) to `page`. With `goes_on` its edge pixels continue a little
/// beyond its edge: a clip must cut them. It has as many pixels as the bitmap has there, within limits. Throws
/// InputError where the warp's grid is too fine for it, or moves it too far.
WarpedBitmap warped_bitmap(const PageBitmap& bitmap, const Warp& page_warp, cv::Size2d page, bool goes_on);

}  // namespace tessera
