// Random numbers of one chain of a nesting. They are counter-based: they depend only on the seed and the draws before.
#pragma once

#include <cstdint>

#include "core/base/portable_math.h"

namespace tessera {

class NestRandom {
 public:
  explicit NestRandom(std::uint64_t key) : key_(mix_bits(key)) {}

  /// A number in [0, 1).
  double unit() { return double(bits() >> 11) * (1.0 / 9007199254740992.0); }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// A number from 0 to count - 1.
  int below(int count) { return int(((bits() >> 32) * std::uint64_t(count)) >> 32); }

 private:
  std::uint64_t bits() { return mix_bits(key_ ^ mix_bits(counter_++)); }

  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace tessera
