// Deforms a picture together with its piece's outline (core/deform/warp.h).
#pragma once

#include <opencv2/core.hpp>

#include "core/deform/warp.h"

namespace tessera {

/// The deformed picture; input and output are CV_8UC4, premultiplied BGRA. `pixel_warp` maps px of the source to px of
/// the result, both continuous: centres of pixels are at + 0.5. A pixel of the result whose centre lies in the image of
/// an active cell's triangle shows the source there, bilinearly, and clear beyond the source's edge; all other pixels
/// are clear. Where the warp folds, the last triangle, row by row, wins. Nothing is averaged: the warp should not
/// shrink by more than 2.
cv::Mat warped_picture(const cv::Mat& bgra, const Warp& pixel_warp, cv::Size size);

/// Deforms a picture on a page in the same way: `source_from_page` places it, `page_warp` maps the page to px of the
/// result.
cv::Mat warped_picture(const cv::Mat& bgra, const cv::Matx23d& source_from_page, const Warp& page_warp, cv::Size size);

}  // namespace tessera
