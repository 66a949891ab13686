#include "core/pad/quantised_pad.h"

#include <algorithm>

namespace tessera {

QuantisedPad quantised(const Pad& pad) {
  QuantisedPad result;
  for (std::size_t e = 0; e < pad.element.size(); ++e) {
    // A damaged library may also contain values that are not above 0.
    if (pad.element[e] > 0) result.element[e] = std::uint16_t(std::min(pad.element[e], 1.f) * float(kPadSteps) + 0.5f);
  }
  return result;
}

QuantisedPad library_pad(QuantisedPad pad) {
  constexpr std::uint32_t kMost = kPadSteps / kLibraryPadSteps;
  for (std::uint16_t& element : pad.element) {
    const std::uint32_t nearest = (element + kLibraryPadSteps / 2) / kLibraryPadSteps;
    element = std::uint16_t(std::min(nearest, kMost) * kLibraryPadSteps);
  }
  return pad;
}

std::uint32_t pad_distance(const QuantisedPad& p, const QuantisedPad& q, int levels) {
  std::uint32_t distance = 0;
  for (int e = 0; e < 2 * (levels - 1); ++e) {
    const std::uint32_t larger = std::max(p.element[e], q.element[e]);
    distance = std::max(distance, larger - std::min(p.element[e], q.element[e]));
  }
  return distance;
}

std::uint32_t pad_steps(float distance) {
  return distance < 1 ? std::uint32_t(std::max(distance, 0.f) * float(kPadSteps) + 0.5f) : kPadSteps + 1;
}

}  // namespace tessera
