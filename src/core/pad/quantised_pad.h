// PADs in whole steps, for matching with a library. Distances are whole numbers, the same on every machine.
#pragma once

#include <array>
#include <cstdint>

#include "core/pad/pad.h"

namespace tessera {

/// Elements of a PAD and distances, in steps: 1 is kPadSteps.
inline constexpr std::uint32_t kPadSteps = 65535;

struct QuantisedPad {
  std::array<std::uint16_t, kMaxPadElements> element{};  // steps

  friend bool operator==(const QuantisedPad&, const QuantisedPad&) = default;
};

QuantisedPad quantised(const Pad& pad);

/// A library keeps 12 bits per element, so that an index of a million shapes has room: elements are multiples of this
/// number of steps. PADs of targets are not rounded.
inline constexpr std::uint32_t kLibraryPadSteps = 16;
/// The PAD rounded to the steps of a library.
QuantisedPad library_pad(QuantisedPad pad);

/// Equation 1 for PADs of the same convexity, steps.
std::uint32_t pad_distance(const QuantisedPad& p, const QuantisedPad& q, int levels);

/// A threshold (beta) in steps, at most one more than the largest distance.
std::uint32_t pad_steps(float distance);

}  // namespace tessera
