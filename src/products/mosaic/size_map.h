// Decides where a mosaic's pieces are small or large: by how much the image changes there, and by how much people look
// there (saliency.h).
#pragma once

#include <opencv2/core.hpp>

#include "products/mosaic/mosaic_plan.h"

namespace tessera {

/// The side of a px of the map, in px of the canvas.
inline constexpr int kSizeMapPixel_px = 4;

/// The size of the map of the plan's canvas, px.
cv::Size size_map_size(const MosaicPlan& plan);

/// The change of the image at each place, for eyes that see no texture finer than the smallest piece. `image_bgr`:
/// CV_8UC3 of any size, laid over the whole canvas. Returns CV_32F, one px for kSizeMapPixel_px of the canvas, in steps of
/// CIELAB for each px.
cv::Mat detail_of(const cv::Mat& image_bgr, const MosaicPlan& plan);

/// The largest size that a piece may have at each place, px of the canvas: CV_32F of the size of `detail`. With these sizes
/// about plan.pieces pieces of one colour each differ least from the image, within the plan's sizes and with gentle changes
/// from place to place.
cv::Mat largest_sizes(const cv::Mat& detail, const MosaicPlan& plan);

/// `detail`, increased where people look. Where `saliency` (CV_32F, 0..1, of detail's size) is 1, the increase takes pieces
/// from the plan's largest size to its smallest.
cv::Mat salient_detail(const cv::Mat& detail, const cv::Mat& saliency, const MosaicPlan& plan);

/// A picture for pieces.size_map, CV_8U: black = the plan's smallest size, white = up to its largest. Equal steps of grey
/// are equal ratios of sizes. `saliency`: of size_map_size(plan).
cv::Mat size_map(const cv::Mat& image_bgr, const MosaicPlan& plan, const cv::Mat& saliency);

}  // namespace tessera
