#include "products/mosaic/mosaic_plan.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"

namespace tessera {
namespace {

/// Square roots of the areas of the smallest and the largest piece. Smaller pieces would be cruder than the field.
constexpr double kMinScale_px = 16;
constexpr double kMaxScale_px = 80;
/// Mean size with the small pieces between the others, measured with the job of mosaic_job().
constexpr double kMeanScale_px = 22;

/// Part of the canvas.
constexpr double kCoverage = 0.88;

/// Pieces for each square of the smallest size s where the largest has the size L: kFilling (s / L)^kFillingExponent +
/// kFillers. Fitted to eight mosaics of 1,100 to 2,600 pieces made from 3,041 shapes, each within 11 %. Where colour counts
/// much, outlines fit less well and leave more room for small pieces.
constexpr double kFilling = 0.626;
constexpr double kFillingExponent = 0.81;
constexpr double kFillers = 0.19;

/// Measured with 4, 14, 44 and 221 shapes: without variety coverage was 14, 4, 2 and 1 points higher, and CIEDE2000 0.4,
/// 2.5, 0.7 and 0.1 lower (docs/decisions/2026-11-27-joints-and-small-libraries.md).
constexpr std::size_t kFewShapes = 100;
constexpr double kRepetitionExponent = 0.3;

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

MosaicVariety mosaic_variety(const MosaicPlan& plan, std::size_t shapes) {
  if (shapes < kFewShapes) return {};
  return {.apart_px = plan.min_scale_px / 2, .repetition_exponent = kRepetitionExponent};
}

double mosaic_pieces_per_px2(double min_scale_px, double largest_px) {
  const double filling = kFilling * std::pow(min_scale_px / largest_px, kFillingExponent);
  return (filling + kFillers) / (min_scale_px * min_scale_px);
}

}  // namespace tessera
