// The parts of an image that differ in colour, as regions of a mosaic.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/mosaic/mosaic_plan.h"

namespace tessera {

inline constexpr int kMostMosaicRegions = 8;

struct Segmentation {
  cv::Mat labels;                  // CV_8U, 0..n-1, one px for kSizeMapPixel_px of the canvas
  std::vector<cv::Vec3b> colours;  // BGR, of each label: the mean of the pixels that made it; no two alike
};

/// `image_bgr`: CV_8UC3 of any size, laid over the whole canvas. At most `regions` (1..kMostMosaicRegions) labels, by
/// colour: fewer where colours are alike, or parts too small, down to one. Each connected part of a label is large
/// enough for several pieces, unless none is. The same labels each time, whatever the threads.
Segmentation segmentation(const cv::Mat& image_bgr, const MosaicPlan& plan, int regions);

/// For canvas.file: each label in its colour, with smooth borders and no mixed colours on them; CV_8UC4, BGRA, twice as
/// wide and high as the canvas, as far as a canvas.file may be.
cv::Mat region_picture(const Segmentation& segmentation, const MosaicPlan& plan);

}  // namespace tessera
