// Conversion of angles to degrees, for texts and files.
#pragma once

#include <numbers>

namespace tessera {

inline constexpr double kDegreesPerRad = 180 / std::numbers::pi;

}  // namespace tessera
