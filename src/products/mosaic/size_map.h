// Where a mosaic's pieces are small and where large: by how much the image changes from place to place, and by how much
// eyes look there (saliency.h).
#pragma once

#include <opencv2/core.hpp>

#include "products/mosaic/mosaic_plan.h"

namespace tessera {

/// A px of the map, in px of the canvas.
inline constexpr int kSizeMapPixel_px = 4;

/// px, of the map of plan's canvas.
cv::Size size_map_size(const MosaicPlan& plan);

/// `image_bgr`: CV_8UC3 of any size, laid over the whole canvas. How much it changes, for eyes that see no texture
/// finer than the smallest piece: CV_32F, one px for kSizeMapPixel_px of the canvas; steps of CIE Lab by px.
cv::Mat detail_of(const cv::Mat& image_bgr, const MosaicPlan& plan);

/// The largest size that a piece may have at each place, px of the canvas: CV_32F of the size of `detail`. Those with
/// which about plan.pieces pieces of one colour each differ least from the image, as far as plan's sizes and a gentle
/// change from place to place allow.
cv::Mat largest_sizes(const cv::Mat& detail, const MosaicPlan& plan);

/// `detail` as it counts where eyes look: as much more as takes pieces from the plan's largest size to its smallest where
/// `saliency` (CV_32F, 0..1, of detail's size) is 1.
cv::Mat salient_detail(const cv::Mat& detail, const cv::Mat& saliency, const MosaicPlan& plan);

/// As a picture for pieces.size_map, CV_8U: black = the plan's smallest size, white = up to its largest; equal steps of
/// grey are equal ratios of sizes. `saliency`: of size_map_size(plan).
cv::Mat size_map(const cv::Mat& image_bgr, const MosaicPlan& plan, const cv::Mat& saliency);

}  // namespace tessera
