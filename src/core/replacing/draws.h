// A sequence of random numbers, the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/portable_math.h"

namespace tessera {

class Draws {
 public:
  explicit Draws(std::uint64_t key) : state_(mix_bits(key)) {}

  std::uint32_t bits() {
    state_ += 0x9e3779b97f4a7c15ull;
    return std::uint32_t(mix_bits(state_) >> 32);
  }
  /// A number in [0, 1).
  float unit() { return unit_float(bits()); }
  /// A number in [0, count); count is below 2^32.
  std::size_t below(std::size_t count) { return std::size_t((std::uint64_t(bits()) * count) >> 32); }

 private:
  std::uint64_t state_;
};

}  // namespace tessera
