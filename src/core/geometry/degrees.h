// Angles as people write them.
#pragma once

#include <numbers>

namespace tessera {

inline constexpr double kDegreesPerRad = 180 / std::numbers::pi;

}  // namespace tessera
