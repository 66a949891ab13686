// Measures how much of a shape's identity remains after its outline was deformed.
#pragma once

#include <vector>

#include "core/deform/warp.h"
#include "core/pad/pad.h"
#include "core/shape/shape.h"

namespace tessera {

/// Compares a shape with its deformed version at corresponding points, by PADs (Equation 1) of the smoothing level that
/// matches the visible detail at its size.
class ShapeIdentity {
 public:
  /// `scale_px`: scale of the piece. The shape's outer curve has evenly spaced points.
  ShapeIdentity(const Shape& shape, float scale_px, const PadParameters& pad);

  /// The mean PAD distance over the samples of the outer curve; 0: nothing has changed.
  float pad_distance(const Warp& warp) const;

 private:
  PadParameters pad_;
  float sigma_ = 0;
  std::vector<Vec2> smooth_;  // the smoothed curve
  std::vector<Pad> samples_;
};

}  // namespace tessera
