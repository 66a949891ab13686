// Arclength pyramids (paper, section 3.2) along open curves, too: a level that would run off an end of the curve is
// missing there.
#pragma once

#include <vector>

#include "core/pad/pad.h"
#include "core/recognition/curve.h"

namespace tessera {

/// A pyramid of which each side has its first levels only: left[0 .. left_levels), right[0 .. right_levels), and the key
/// points of these.
struct PartialPyramid {
  ArclengthPyramid pyramid;
  int left_levels = 0;
  int right_levels = 0;
};

/// Fewer levels than this say too little: of five on each side, six.
inline constexpr int kLeastLevels = 4;
inline constexpr int kLeastLevelsOfASide = 2;

/// Whether both sides have levels enough to be compared.
bool tells_enough(const PartialPyramid& pyramid);

/// Pyramids at every `stride`-th point of a curve that was smoothed by `sigma`. Of an open curve the last `sigma` before
/// its ends counts as missing: smoothing has changed it.
std::vector<PartialPyramid> partial_pyramids(const Curve& smooth_curve, float sigma, int stride,
                                             const PadParameters& pad);

}  // namespace tessera
