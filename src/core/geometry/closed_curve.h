// Closed polylines: length, evenly spaced points, smoothing along the length.
#pragma once

#include <vector>

#include "core/geometry/vec2.h"

namespace tessera {

/// The closed curve of evenly spaced points, convolved with a Gaussian of width `sigma` along its length (cut off at 3
/// sigma).
std::vector<Vec2> gaussian_smoothed(const std::vector<Vec2>& even_curve, float sigma);

float closed_length(const std::vector<Vec2>& curve);

/// `count` points of a closed polyline at even arclength, beginning with its first point.
std::vector<Vec2> resampled_closed(const std::vector<Vec2>& curve, int count);

}  // namespace tessera
