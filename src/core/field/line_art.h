// Pieces that consist of lines. Where two of them cross, no point of one is deep in the other. So the depth that is
// allowed between ordinary pieces would let all lines cross that are narrower than twice that depth.
#pragma once

#include <algorithm>

#include "core/settings/tuning.h"

namespace tessera {

/// Largest depth in a line, as a fraction of half its width. A smaller value would allow lines no overlap; with a
/// larger one they could cross between the vertices of an outline.
inline constexpr float kMostDepthInLine = 0.7f;

/// The largest depth of one piece in another if `depth_px` is allowed in general. `line_radius_px`: half the width of
/// their lines (line_radius(), times the scale); infinite: neither piece consists of lines.
inline float most_depth_px(float depth_px, float line_radius_px) {
  return std::min(depth_px, kMostDepthInLine * line_radius_px);
}

/// The depth inside a piece as the free field stores it. In a piece of lines it grows faster, so that the generally
/// allowed depth is reached at most_depth_px().
class StoredDepth {
 public:
  StoredDepth(float depth_px, float line_radius_px) {
    const float most_px = most_depth_px(depth_px, line_radius_px);
    if (most_px < depth_px && depth_px > kRim_px)
      steepness_ = (depth_px - kRim_px) / std::max(most_px - kRim_px, kLeastRoom_px);
  }

  /// The stored value of a signed distance to the piece, px, positive outside.
  float operator()(float distance_px) const {
    return distance_px < -kRim_px ? (distance_px + kRim_px) * steepness_ - kRim_px : distance_px;
  }

 private:
  static constexpr float kRim_px = 0.5f;        // depths up to this stay exact, as areas are counted by the distance
  static constexpr float kLeastRoom_px = 0.1f;  // in narrower lines the field's nodes hardly see the middle

  float steepness_ = 1;
};

}  // namespace tessera
