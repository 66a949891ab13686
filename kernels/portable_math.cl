// core/base/portable_math.h in OpenCL C, bit for bit.
//
// Rule for all kernels: only + - * / sqrt floor fabs min max and comparisons, in the same order as the reference, and
// no built-in whose rounding may differ (mad, fma, native_*, dot, length). Tunables come from the host under their
// names. Other constants of a reference's function are repeated in its kernel; tests/worker compares the bits of both.
#pragma OPENCL FP_CONTRACT OFF

// Marks functions whose values must stay in registers across calls.
#define INLINE __attribute__((always_inline)) inline

// Claims `n` places, from the result on, in a list that many work items fill. Counters stop at about 2^31 and never
// wrap round.
uint claim_places(global uint* count, uint n) {
  const uint place = atomic_add(count, n);
  if (place >= 0x80000000u) atomic_sub(count, n);
  return place;
}

// e^(f ln 2) for 0 <= f < 1, for a float or for lanes of floats.
#define EXP2_OF_FRACTION(F, p, f)  \
  const F y = f * 0.69314718f;     \
  F p = 1.98412698e-4f;            \
  p = p * y + 1.38888889e-3f;      \
  p = p * y + 8.33333333e-3f;      \
  p = p * y + 4.16666667e-2f;      \
  p = p * y + 1.66666667e-1f;      \
  p = p * y + 0.5f;                \
  p = p * y + 1.f;                 \
  p = p * y + 1.f

float portable_exp2(float x) {
  const float whole = floor(x);
  EXP2_OF_FRACTION(float, p, (x - whole));
  for (int k = (int)whole; k > 0; --k) p = p * 2.f;
  for (int k = (int)whole; k < 0; ++k) p = p * 0.5f;
  return p;
}

ulong mix_bits(ulong z) {
  z += 0x9e3779b97f4a7c15ul;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ul;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebul;
  return z ^ (z >> 31);
}

float unit_float(uint bits) { return (float)(bits >> 8) * (1.f / 16777216.f); }
