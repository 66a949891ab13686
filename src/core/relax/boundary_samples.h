// Points of an outline at which contacts are felt: its corners, and even steps between them. Shape frame.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/polygon.h"

namespace tessera {

struct BoundarySample {
  Vec2 position;
  float length = 0;  // of the boundary that it stands for, shape units
};

struct BoundarySamples {
  std::vector<BoundarySample> samples;  // curve after curve, along each
  std::vector<std::size_t> curve_ends;  // in `samples`, one past each curve's last
  float longest_step = 0;               // along the boundary, between two that follow each other, shape units
};

/// Corners are those vertices that a polygon needs to stay within `tolerance` of the outline; between them lie steps of
/// at most `spacing`. Both are shape units. The lengths add up to the outline's.
BoundarySamples sample_boundary(const Outline& outline, float spacing, float tolerance);

}  // namespace tessera
