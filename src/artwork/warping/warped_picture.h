// A picture deformed with its piece's outline (core/deform/warp.h).
#pragma once

#include <opencv2/core.hpp>

#include "core/deform/warp.h"

namespace tessera {

/// The picture deformed: CV_8UC4, premultiplied BGRA, in and out. `pixel_warp` maps px of the source to px of the result,
/// both continuous: centres of pixels lie at + 0.5. A result's pixel whose centre lies in the image of an active cell's
/// triangle shows the source there, bilinearly, nothing beyond the source's edge; all others are clear. Where the warp
/// folds, the last triangle, row by row, counts. Nothing is averaged: the warp should not shrink by more than 2.
cv::Mat warped_picture(const cv::Mat& bgra, const Warp& pixel_warp, cv::Size size);

/// The same of a picture that lies on a page by `source_from_page`, `page_warp` mapping the page to px of the result.
cv::Mat warped_picture(const cv::Mat& bgra, const cv::Matx23d& source_from_page, const Warp& page_warp, cv::Size size);

}  // namespace tessera
