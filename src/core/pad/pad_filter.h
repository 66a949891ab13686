// An exact filter before the PAD distance: a byte for each element, one for the length that estimates the scale and one
// for the sign. A pair that passes may be near; a pair that fails is not near (tests/core/pad/test_pad_filter.cpp).
// With it, kernels/pairs.cl tests the 64 PADs of an index block at a time. The reference matcher does not use it.
//
// Element e of a sample passes if low[e] <= byte <= high[e]. A byte passes only if some element with this byte is
// within reach.
#pragma once

#include <array>
#include <cstdint>

#include "core/pad/quantised_pad.h"

namespace tessera {

inline std::uint8_t pad_byte(std::uint16_t element_steps) { return std::uint8_t(element_steps >> 8); }

/// Two convexities may match if their bytes have a common bit; a flat point agrees with both.
inline std::uint8_t sign_byte(float convexity) { return convexity > 0 ? 1 : convexity < 0 ? 2 : 3; }

/// A positive length (shape units) on a scale of 16 steps per octave.
std::uint8_t scale_byte(float length);

/// The bytes that pairs nearer than a reach (above 0) must have. Inclusive bounds.
struct PadWindow {
  std::array<std::uint8_t, kMaxPadElements> low{};
  std::array<std::uint8_t, kMaxPadElements> high{};
};
PadWindow pad_window(const QuantisedPad& target, std::uint32_t reach_steps);

struct ScaleWindow {
  std::uint8_t low = 0;
  std::uint8_t high = 0;
};
/// The window for lengths between `least` and `most`, shape units.
ScaleWindow scale_window(float least, float most);

}  // namespace tessera
