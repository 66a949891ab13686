// Settings with all sizes multiplied.
#pragma once

#include <cstdint>
#include <vector>

#include "core/settings/settings.h"

namespace tessera {

/// The settings with the sizes of pieces, shapes and regions times the factor.
CollageSettings with_sizes_times(double factor, CollageSettings settings);

/// The factor, at most 1, at which the smallest piece has the least size that it may have with fit = "all"; else 1. It
/// is known from the start on every rank, so that all are ready for each factor from there to 1.
float least_size_factor(const PieceSettings& pieces);

/// The factor at which the pieces that must find a place (UseLimits), without those that are given, fill kFirstFilling
/// of what given pieces leave of the area; no smaller than the least size allows.
/// `drawings`: for each shape the one that it is the mirror image of, mostly itself; empty: there are no mirror images.
double first_size_factor(const CollageSettings& settings, std::uint32_t library_shapes, double area_px2,
                         const std::vector<std::uint32_t>& drawings = {});

}  // namespace tessera
