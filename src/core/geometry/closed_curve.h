// Closed polylines: their length, even points along them, and smoothing along their length.
#pragma once

#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// Closed curve of evenly spaced points convolved with a Gaussian of width sigma (cut off at 3 sigma) along its length.
std::vector<Vec2> gaussian_smoothed(const std::vector<Vec2>& even_curve, float sigma);

float closed_length(const std::vector<Vec2>& curve);

/// `count` points of even arclength of a closed polyline, the first one kept.
std::vector<Vec2> resampled_closed(const std::vector<Vec2>& curve, int count);

}  // namespace tessera
