// Converts pictures whose ICC profile describes other colours than sRGB.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>

namespace tessera {

/// Converts the colours to sRGB; alpha stays. `pixels`: 8 or 16 bits; grey, BGR or straight BGRA; no other matrix may
/// share them. `profile`: an ICC profile, or empty. A profile is ignored where it is damaged, has other channels than
/// the picture, or is sRGB apart from rounding.
void make_srgb(cv::Mat& pixels, std::span<const std::uint8_t> profile);

}  // namespace tessera
