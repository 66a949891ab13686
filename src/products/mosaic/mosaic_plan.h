// How large the canvas of a mosaic is and how large its pieces may be, so that about as many come out as are wished.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>

namespace tessera {

inline constexpr int kFewestMosaicPieces = 100;
inline constexpr int kMostMosaicPieces = 40'000;

/// Longer by shorter side of the image at most, so that the largest canvas is one that a job may have.
inline constexpr double kMostMosaicAspect = 8;

struct MosaicPlan {
  int pieces = 0;
  cv::Size canvas_px;
  double min_scale_px = 0;  // square root of the smallest piece's area
  double max_scale_px = 0;
};

/// How much a mosaic avoids to show the same drawing again.
struct MosaicVariety {
  double apart_px = 0;             // of the canvas, between the outlines of two of the same drawing
  double repetition_exponent = 0;  // as objective.repetition_exponent of a job
};

/// `image`: its size, of the canvas' aspect. Throws InputError that names what was found and what is allowed.
MosaicPlan mosaic_plan(cv::Size image, int pieces);

/// `shapes`: of all libraries. Below 100 shapes there is none: drawings that may not lie again leave gaps and give way
/// to colours that are further off.
MosaicVariety mosaic_variety(const MosaicPlan& plan, std::size_t shapes);

/// Pieces that a canvas px² gets where the largest may have the size `largest_px`: those that fill it, and the small
/// ones between them.
double pieces_per_px2(const MosaicPlan& plan, double largest_px);

}  // namespace tessera
