// Colours of pictures whose makers had another screen or camera in mind than sRGB.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>

namespace tessera {

/// Makes sRGB of the colours; alpha stays. `pixels`: 8 or 16 bits; grey, BGR or straight BGRA; nothing else may look at
/// them. `profile`: an ICC profile, or empty. One that is damaged, or of other channels than the picture has, is passed
/// over, and so is one that is sRGB but for rounding.
void make_srgb(cv::Mat& pixels, std::span<const std::uint8_t> profile);

}  // namespace tessera
