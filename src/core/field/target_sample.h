// The target samples: where on the boundary of the free region shapes are docked.
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
  std::uint32_t pass = 0;    // how often it was matched before: other random draws each time
  Vec2 position;             // on the curve itself
  Vec2 tangent;              // unit
  ArclengthPyramid pyramid;  // of the curve smoothed by target_sigma_px
};

/// What a sample's PAD was when it was last to be matched: it decides whether the PAD has changed much since.
struct MatchedPad {
  SampleId sample{};
  std::array<float, kMaxPadLevels> left{};
  std::array<float, kMaxPadLevels> right{};
  float convexity = 0;

  friend bool operator==(const MatchedPad&, const MatchedPad&) = default;
};

}  // namespace tessera
