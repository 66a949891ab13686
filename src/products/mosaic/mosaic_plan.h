// Plans the canvas of a mosaic and the sizes of its pieces, so that about as many pieces result as wished.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>

namespace tessera {

inline constexpr int kFewestMosaicPieces = 100;
inline constexpr int kMostMosaicPieces = 40'000;

/// Largest ratio of the image's sides: the largest canvas is then one that a job may have.
inline constexpr double kMostMosaicAspect = 8;

struct MosaicPlan {
  int pieces = 0;
  cv::Size canvas_px;
  double min_scale_px = 0;  // square root of the smallest piece's area
  double max_scale_px = 0;
};

/// The strength with which a mosaic avoids showing the same drawing again.
struct MosaicVariety {
  double apart_px = 0;             // distance between the outlines of two pieces of the same drawing, canvas px
  double repetition_exponent = 0;  // the job's objective.repetition_exponent
};

/// `image`: its size, which has the canvas' aspect. Throws InputError that names what was found and what is allowed.
MosaicPlan mosaic_plan(cv::Size image, int pieces);

/// `shapes`: in all libraries. Below 100 shapes there is no variety: drawings that may not be repeated would leave gaps,
/// and less suitable colours would take their places.
MosaicVariety mosaic_variety(const MosaicPlan& plan, std::size_t shapes);

/// Pieces for each px² of a mosaic where the largest may have the size `largest_px`: those that fill the area, and the small
/// ones between them.
double mosaic_pieces_per_px2(double min_scale_px, double largest_px);

}  // namespace tessera
