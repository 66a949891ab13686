#include "products/mosaic/size_map.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "products/elements/segmentation/boundary_map.h"
#include "products/mosaic/size_gradation.h"

namespace tessera {
namespace {

/// The Gaussian before the steepness is computed, px of the map: about a third of the smallest piece.
constexpr double kGradientSigma_px = 1.5;
/// The Gaussian that takes the detail of a place as large as a piece, px of the map.
constexpr double kPlaceSigma_px = 5;
/// Detail (steps of CIELAB for each px) that no eye sees; with less, everything is flat.
constexpr double kFlat = 0.5;
/// With the size s and the detail g, a piece of one colour has an error of about g s. For a fixed number of pieces, the
/// integral of 1 / s², the sum of errors is least where s is proportional to g to the power -1/3.
constexpr double kDetailExponent = 1. / 3;
/// Growth of sizes for each px of the canvas: a neighbour of a piece may be larger by the piece's width.
constexpr double kGrowth = 1;

/// The sizes, given the detail at which pieces are smallest.
cv::Mat sizes_for(const cv::Mat& detail, double detail_of_smallest, const MosaicPlan& plan) {
  cv::Mat sizes;
  cv::pow(detail_of_smallest / detail, kDetailExponent, sizes);
  sizes = cv::min(cv::max(sizes * plan.min_scale_px, plan.min_scale_px), plan.max_scale_px);
  limit_growth(sizes, float(kGrowth * kSizeMapPixel_px));
  return sizes;
}

double expected_pieces(const cv::Mat& sizes, const MosaicPlan& plan) {
  double sum = 0;
  for (int y = 0; y < sizes.rows; ++y) {
    for (int x = 0; x < sizes.cols; ++x) sum += mosaic_pieces_per_px2(plan.min_scale_px, sizes.at<float>(y, x));
  }
  return sum / double(sizes.total()) * plan.canvas_px.area();
}

}  // namespace

cv::Size size_map_size(const MosaicPlan& plan) {
  const auto along = [](int canvas_px) { return std::max(1, (canvas_px + kSizeMapPixel_px / 2) / kSizeMapPixel_px); };
  return {along(plan.canvas_px.width), along(plan.canvas_px.height)};
}

cv::Mat detail_of(const cv::Mat& image_bgr, const MosaicPlan& plan) {
  const cv::Size size = size_map_size(plan);
  const bool shrinks = image_bgr.cols > size.width;
  cv::Mat picture, detail;
  cv::resize(image_bgr, picture, size, 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  constexpr double kSobelGain = 8;
  cv::GaussianBlur(colour_gradient(smooth_lab(picture), kGradientSigma_px, 1) / kSobelGain, detail, {}, kPlaceSigma_px);
  return cv::max(detail, kFlat);
}

cv::Mat largest_sizes(const cv::Mat& detail, const MosaicPlan& plan) {
  double least = 0, most = 0;
  cv::minMaxLoc(detail, &least, &most);
  const double range = std::log(plan.max_scale_px / plan.min_scale_px) / kDetailExponent;
  double low = std::log(least), high = std::log(most) + range;  // from all pieces smallest to all largest
  constexpr int kHalvings = 25;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    const bool too_many = expected_pieces(sizes_for(detail, std::exp(middle), plan), plan) > plan.pieces;
    (too_many ? low : high) = middle;
  }
  return sizes_for(detail, std::exp(high), plan);
}

cv::Mat salient_detail(const cv::Mat& detail, const cv::Mat& saliency, const MosaicPlan& plan) {
  cv::Mat factors;
  cv::exp(saliency * (std::log(plan.max_scale_px / plan.min_scale_px) / kDetailExponent), factors);
  return detail.mul(factors);
}

cv::Mat size_map(const cv::Mat& image_bgr, const MosaicPlan& plan, const cv::Mat& saliency) {
  const cv::Mat sizes = largest_sizes(salient_detail(detail_of(image_bgr, plan), saliency, plan), plan);
  cv::Mat octaves, map;
  cv::log(sizes / plan.min_scale_px, octaves);
  octaves.convertTo(map, CV_8U, 255 / std::log(plan.max_scale_px / plan.min_scale_px));
  return map;
}

}  // namespace tessera
