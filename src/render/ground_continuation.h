// Continues a photo's ground into small gaps that no photo shows.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// The most px from a place to what counts for it.
inline constexpr int kContinuation_px = 20;

/// Gives pixels that show nothing yet (alpha 0) the grains of ground nearby, up to 12 px from it. `pixels`: CV_8UC4, alpha 255
/// where something is shown. `is_piece`: CV_8U, 255 where no ground lies.
void continue_ground(const cv::Mat& is_piece, cv::Mat& pixels);

/// Blurs these pixels (CV_8U: 255) by a little, where hard edges would be seen, except beside pixels that show nothing.
void soften(const cv::Mat& which, cv::Mat& pixels);

}  // namespace tessera
