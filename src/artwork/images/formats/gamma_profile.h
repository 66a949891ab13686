// Makes an ICC profile from numbers: a PNG may describe its colours by gamma and primaries.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tessera {

/// Points in the CIE xy diagram.
struct Chromaticities {
  std::array<double, 2> white, red, green, blue;
};

inline constexpr Chromaticities kSrgbChromaticities = {{0.3127, 0.3290}, {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}};

/// Whether these are the numbers that programs write for sRGB, whose curve is not a power.
bool is_about_srgb(double gamma, const Chromaticities& colours);

/// An ICC profile for values that are light to the power of `gamma` (sRGB: about 1 / 2.2). `colours` do not matter for
/// a grey picture. Empty where the numbers make no sense.
std::vector<std::uint8_t> gamma_profile(double gamma, const Chromaticities& colours, bool grey);

}  // namespace tessera
