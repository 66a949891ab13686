// Arclength pyramids (paper, section 3.2) of closed and open curves. On an open curve, a level that would leave the
// curve at an end is missing.
#pragma once

#include <vector>

#include "core/pad/pad.h"
#include "core/recognition/curve.h"

namespace tessera {

/// A pyramid with only the first levels on each side: left[0 .. left_levels), right[0 .. right_levels), and their key
/// points.
struct PartialPyramid {
  ArclengthPyramid pyramid;
  int left_levels = 0;
  int right_levels = 0;
};

/// The least number of levels of both sides together, and of each side. With fewer a pyramid says too little.
inline constexpr int kLeastLevels = 4;
inline constexpr int kLeastLevelsOfASide = 2;

/// Whether both sides have enough levels for a comparison.
bool has_enough_levels(const PartialPyramid& pyramid);

/// The pyramids at every `stride`-th point of a curve that was smoothed by `sigma`. On an open curve the last `sigma`
/// before each end counts as missing, because smoothing has changed it.
std::vector<PartialPyramid> partial_pyramids(const Curve& smooth_curve, float sigma, int stride,
                                             const PadParameters& pad);

}  // namespace tessera
