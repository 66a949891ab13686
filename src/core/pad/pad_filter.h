// An exact filter before the PAD distance: a byte for each element, one for the length that estimates the scale and
// one for the sign. A pair that passes may be near; one that does not pass is not near
// (tests/core/pad/test_pad_filter.cpp). kernels/pairs.cl tests the 64 PADs of a block of the index at a time with it; the
// reference does without.
//
// Element e of a sample passes where low[e] <= byte <= high[e]: no byte passes of which none is within reach.
#pragma once

#include <array>
#include <cstdint>

#include "core/pad/quantised_pad.h"

namespace tessera {

inline std::uint8_t pad_byte(std::uint16_t element_steps) { return std::uint8_t(element_steps >> 8); }

/// Convexities may meet where their bytes have a bit in common: a flat point agrees with either.
inline std::uint8_t sign_byte(float convexity) { return convexity > 0 ? 1 : convexity < 0 ? 2 : 3; }

/// A positive length (shape units) in sixteenths of an octave.
std::uint8_t scale_byte(float length);

/// The bytes that pairs nearer than a reach, above 0, must have. Inclusive.
struct PadWindow {
  std::array<std::uint8_t, kMaxPadElements> low{};
  std::array<std::uint8_t, kMaxPadElements> high{};
};
PadWindow pad_window(const QuantisedPad& target, std::uint32_t reach_steps);

struct ScaleWindow {
  std::uint8_t low = 0;
  std::uint8_t high = 0;
};
/// The window of the lengths between `least` and `most`, shape units.
ScaleWindow scale_window(float least, float most);

}  // namespace tessera
