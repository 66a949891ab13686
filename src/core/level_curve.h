// The outer curve of a library shape at one smoothing level, with its PADs (design, methods 1 and 2).
#pragma once

#include <vector>

#include "core/shape.h"

namespace tessera {

/// `outer_curve`: closed, even arclength, interior on the left, spacing well below level.sigma. Any frame in which
/// level.sigma is a length; for the library the shape frame.
LevelCurve make_level_curve(const std::vector<Vec2>& outer_curve, const SmoothingLevel& level,
                            const PadParameters& pad);

/// The pyramids of `samples` evenly chosen points of a smoothed closed curve.
std::vector<ArclengthPyramid> sample_pyramids(const std::vector<Vec2>& smooth_curve, float sigma, int samples,
                                              const PadParameters& pad);

/// Closed curve of evenly spaced points convolved with a Gaussian of width sigma (cut off at 3 sigma) along its length.
std::vector<Vec2> gaussian_smoothed(const std::vector<Vec2>& even_curve, float sigma);

float closed_length(const std::vector<Vec2>& curve);

/// `count` points of even arclength of a closed polyline, the first one kept.
std::vector<Vec2> resampled_closed(const std::vector<Vec2>& curve, int count);

}  // namespace tessera
