// Divides an image into parts of different colour, for the regions of a mosaic.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/mosaic/mosaic_plan.h"

namespace tessera {

inline constexpr int kMostMosaicRegions = 8;

struct Segmentation {
  cv::Mat labels;                  // CV_8U, 0..n-1, one px for kSizeMapPixel_px of the canvas
  std::vector<cv::Vec3b> colours;  // BGR of each label: the mean of its pixels; no two are equal
};

/// `image_bgr`: CV_8UC3 of any size, laid over the whole canvas. Returns at most `regions` (1..kMostMosaicRegions) labels,
/// by colour; fewer, down to one, where colours are similar or parts too small. Each connected part of a label is large
/// enough for several pieces, unless none is. The labels are the same on any number of threads.
Segmentation segmentation(const cv::Mat& image_bgr, const MosaicPlan& plan, int regions);

/// The picture for canvas.file: each label in its colour, with smooth borders without mixed colours. CV_8UC4, BGRA, twice
/// as wide and high as the canvas, as far as a canvas.file may be.
cv::Mat region_picture(const Segmentation& segmentation, const MosaicPlan& plan);

}  // namespace tessera
