// Where on the boundary of the free region shapes are docked.
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/vec2.h"
#include "core/pad/pad.h"

namespace tessera {

/// A point of the target curve where shapes are docked. Canvas px; the free region lies on the left.
struct TargetSample {
  std::uint32_t edge = 0;  // its name: 2 (y · width + x), +1 for the edge from (x, y) down to (x, y + 1)
  std::uint32_t pass = 0;  // how often it was matched before: other random draws each time
  Vec2 position;           // on the curve itself
  Vec2 tangent;            // unit
  ArclengthPyramid pyramid;  // of the curve smoothed by target_sigma_px
};

/// Of a sample's PAD when it was last to be matched: what decides whether it has changed much since.
struct MatchedPad {
  std::uint32_t edge = 0;
  std::array<float, kMaxPadLevels> left{};
  std::array<float, kMaxPadLevels> right{};
  float convexity = 0;

  friend bool operator==(const MatchedPad&, const MatchedPad&) = default;
};

}  // namespace tessera
