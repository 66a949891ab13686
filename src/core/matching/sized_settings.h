// Settings with all sizes multiplied.
#pragma once

#include <cstdint>
#include <vector>

#include "core/settings/settings.h"

namespace tessera {

/// The settings with the sizes of pieces, shapes and regions times the factor.
CollageSettings with_sizes_times(double factor, CollageSettings settings);

/// The factor, at most 1, at which the smallest piece has the least size that fit = "all" allows; otherwise 1. Every
/// rank knows it from the start, so that all are ready for each factor from there to 1.
float least_size_factor(const PieceSettings& pieces);

/// The factor of the first attempt. With it, the pieces that must find a place (UseLimits) and are not given fill
/// kFirstFilling of the area that the given pieces leave. It is never below the factor of the least size. `drawings`:
/// for each shape the shape whose mirror image it is, or itself; empty: there are no mirror images.
double first_size_factor(const CollageSettings& settings, std::uint32_t library_shapes, double area_px2,
                         const std::vector<std::uint32_t>& drawings = {});

}  // namespace tessera
