#include "core/pad/pad_filter.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

constexpr float kBytesAnOctave = 16;
constexpr float kByteOfOne = 160;  // lengths from 2^-10 to 2^6; no pieces lie beyond, only the ends of the range

}  // namespace

std::uint8_t scale_byte(float length) {
  const float byte = kByteOfOne + kBytesAnOctave * std::log2(std::max(length, 1e-9f));
  return std::uint8_t(std::clamp(byte, 0.f, 255.f));
}

PadWindow pad_window(const QuantisedPad& target, std::uint32_t reach_steps) {
  const int most = int(std::max(reach_steps, 1u)) - 1;
  PadWindow window;
  for (std::size_t e = 0; e < window.low.size(); ++e) {
    const int element = target.element[e];
    window.low[e] = pad_byte(std::uint16_t(std::max(element - most, 0)));
    window.high[e] = pad_byte(std::uint16_t(std::min(element + most, int(kPadSteps))));
  }
  return window;
}

ScaleWindow scale_window(float least, float most) {
  // One more on each side: logarithms may round either way.
  const int low = std::max(int(scale_byte(least)) - 1, 0);
  const int high = std::min(int(scale_byte(most)) + 1, 255);
  return {std::uint8_t(low), std::uint8_t(high)};
}

}  // namespace tessera
