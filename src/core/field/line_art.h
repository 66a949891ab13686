// Pieces that consist of lines. Where two of them cross, none of their points is deep in the other one: a depth that is
// allowed between ordinary pieces would let all lines cross that are narrower than twice that depth.
#pragma once

#include <algorithm>

#include "core/settings/tuning.h"

namespace tessera {

/// Of half the width of a line: so deep at most may something lie in it. Less would leave lines no overlap; with more
/// they could cross between the vertices of an outline.
inline constexpr float kMostDepthInLine = 0.7f;

/// How deep a piece may lie in another one, where `depth_px` is allowed in general and the lines of the two have this
/// half width (line_radius(), times the scale; infinite: neither consists of lines).
inline float most_depth_px(float depth_px, float line_radius_px) {
  return std::min(depth_px, kMostDepthInLine * line_radius_px);
}

/// The depths inside a piece as the free field holds them: in one of lines they grow faster, so that the depth that is
/// allowed in general is reached at most_depth_px().
class HeldDepth {
 public:
  HeldDepth(float depth_px, float line_radius_px) {
    const float most_px = most_depth_px(depth_px, line_radius_px);
    if (most_px < depth_px && depth_px > kRim_px)
      steepness_ = (depth_px - kRim_px) / std::max(most_px - kRim_px, kLeastRoom_px);
  }

  /// Of a signed distance to the piece, px, positive outside.
  float operator()(float distance_px) const {
    return distance_px < -kRim_px ? (distance_px + kRim_px) * steepness_ - kRim_px : distance_px;
  }

 private:
  static constexpr float kRim_px = 0.5f;        // where areas are counted by the distance
  static constexpr float kLeastRoom_px = 0.1f;  // of narrower lines the field's nodes hardly see the middle

  float steepness_ = 1;
};

}  // namespace tessera
