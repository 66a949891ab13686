#include "io/mosaic/mosaic_plan.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"

namespace tessera::io {
namespace {

/// The square root of a piece's area, in the mean. Pieces of half of it are still matched well.
constexpr double kMeanScale_px = 32;
constexpr double kMinScale_px = kMeanScale_px / 2;
constexpr double kMaxScale_px = kMeanScale_px * 2;

/// Of the canvas.
constexpr double kCoverage = 0.9;

/// Pieces for each square of the largest size that is allowed at a place, and small ones between them for each square of
/// the smallest. Measured on mosaics of 800 to 3,400 pieces out of 521 and 6,455 shapes: with both, the number of pieces
/// was true to 5 %.
constexpr double kFilling = 1;
constexpr double kFillers = 0.06;

std::string size_text(cv::Size size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

void check(cv::Size image, int pieces) {
  if (pieces < kFewestMosaicPieces || pieces > kMostMosaicPieces) {
    throw InputError("--pieces: found " + std::to_string(pieces) + ", allowed: from " +
                     std::to_string(kFewestMosaicPieces) + " to " + std::to_string(kMostMosaicPieces));
  }
  if (std::max(image.width, image.height) > kMostMosaicAspect * std::min(image.width, image.height)) {
    throw InputError("found an image of " + size_text(image) + " px, allowed: one side at most " +
                     std::to_string(int(kMostMosaicAspect)) + " times the other; crop it");
  }
}

}  // namespace

MosaicPlan mosaic_plan(cv::Size image, int pieces) {
  check(image, pieces);
  const double area_px2 = pieces * kMeanScale_px * kMeanScale_px / kCoverage;
  const double aspect = double(image.width) / image.height;
  const double width_px = std::sqrt(area_px2 * aspect);
  return {.pieces = pieces,
          .canvas_px = {int(std::lround(width_px)), int(std::lround(width_px / aspect))},
          .min_scale_px = kMinScale_px,
          .max_scale_px = kMaxScale_px};
}

double pieces_per_px2(const MosaicPlan& plan, double largest_px) {
  return kFilling / (largest_px * largest_px) + kFillers / (plan.min_scale_px * plan.min_scale_px);
}

}  // namespace tessera::io
