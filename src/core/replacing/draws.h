// Random numbers one after another, the same anywhere.
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
  /// In [0, 1).
  float unit() { return unit_float(bits()); }
  /// In [0, count), count below 2^32.
  std::size_t below(std::size_t count) { return std::size_t((std::uint64_t(bits()) * count) >> 32); }

 private:
  std::uint64_t state_;
};

}  // namespace tessera
