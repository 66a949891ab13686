// The target samples: points of the free region's boundary where shapes are docked.
#pragma once

#include <array>
#include <cstdint>

#include "core/field/sample_id.h"
#include "core/geometry/vec2.h"
#include "core/pad/pad.h"

namespace tessera {

/// A point of the target curve where shapes are docked. Canvas px; the free region lies on the left.
struct TargetSample {
  SampleId id{};
  std::uint32_t pass = 0;    // how often it was matched before; each pass has other random draws
  Vec2 position;             // on the curve itself
  Vec2 tangent;              // unit
  ArclengthPyramid pyramid;  // of the curve smoothed by target_sigma_px
};

/// A sample's PAD when it was last due to be matched. It shows whether the PAD has changed much since.
struct MatchedPad {
  SampleId sample{};
  std::array<float, kMaxPadLevels> left{};
  std::array<float, kMaxPadLevels> right{};
  float convexity = 0;

  friend bool operator==(const MatchedPad&, const MatchedPad&) = default;
};

}  // namespace tessera
