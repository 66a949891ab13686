// Points of an outline where contacts are measured: its corners, and even steps between them. Shape frame.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/polygon.h"

namespace tessera {

struct BoundarySample {
  Vec2 position;
  float length = 0;  // of the boundary that the sample stands for, shape units
};

struct BoundarySamples {
  std::vector<BoundarySample> samples;  // curve after curve, in order along each
  std::vector<std::size_t> curve_ends;  // for each curve, one past its last index in `samples`
  float longest_step = 0;               // largest step along the boundary between two successive samples, shape units
};

/// Corners are the vertices that a polygon needs to stay within `tolerance` of the outline; the steps between them are
/// at most `spacing` long. Both in shape units. The samples' lengths add up to the outline's.
BoundarySamples sample_boundary(const Outline& outline, float spacing, float tolerance);

}  // namespace tessera
