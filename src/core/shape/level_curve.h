// The outer curve of a library shape at one smoothing level, with its PADs (paper section 3.2).
#pragma once

#include <vector>

#include "core/shape/shape.h"

namespace tessera {

/// `outer_curve`: closed, even arclength, interior on the left, spacing well below level.sigma. level.sigma is a length
/// in the frame of the curve; for the library that is the shape frame.
LevelCurve make_level_curve(const std::vector<Vec2>& outer_curve, const SmoothingLevel& level,
                            const PadParameters& pad);

/// The pyramids of `samples` evenly spaced points of a smoothed closed curve.
std::vector<ArclengthPyramid> sample_pyramids(const std::vector<Vec2>& smooth_curve, float sigma, int samples,
                                              const PadParameters& pad);

}  // namespace tessera
