// Functions that give the same bits on every host and device. They consist of +, -, *, / and sqrt only, which IEEE 754
// defines exactly, in the order written. kernels/portable_math.cl has the ones that kernels need.
#pragma once

#include <cmath>
#include <cstdint>

namespace tessera {

/// 2^x for -64 < x < 64, relative error below 1e-6.
inline float portable_exp2(float x) {
  const float whole = std::floor(x);
  const float f = x - whole;
  // Taylor series of e^(f ln 2), Horner.
  const float y = f * 0.69314718f;
  float p = 1.98412698e-4f;
  p = p * y + 1.38888889e-3f;
  p = p * y + 8.33333333e-3f;
  p = p * y + 4.16666667e-2f;
  p = p * y + 1.66666667e-1f;
  p = p * y + 0.5f;
  p = p * y + 1.f;
  p = p * y + 1.f;
  for (int k = int(whole); k > 0; --k) p = p * 2.f;
  for (int k = int(whole); k < 0; ++k) p = p * 0.5f;
  return p;
}

/// The natural logarithm of a positive number, relative error below 1e-9.
inline double portable_log(double x) {
  constexpr double kLog2 = 0.6931471805599453;
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // exact
  if (m < 0.7071067811865476) {
    m *= 2;
    --exponent;
  }
  // ln m = 2 atanh t, and |t| < 0.172.
  const double t = (m - 1) / (m + 1);
  const double t2 = t * t;
  const double series = 1 + t2 * (1.0 / 3 + t2 * (1.0 / 5 + t2 * (1.0 / 7 + t2 * (1.0 / 9 + t2 * (1.0 / 11)))));
  return exponent * kLog2 + 2 * t * series;
}

/// Counter-based random bits: mixes a key (splitmix64's finaliser). The same key gives the same bits on every machine.
inline std::uint64_t mix_bits(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// A number in [0, 1) from the upper 24 bits.
inline float unit_float(std::uint32_t bits) { return float(bits >> 8) * (1.f / 16777216.f); }

}  // namespace tessera
