// Settings with all sizes multiplied.
#pragma once

#include <cstdint>
#include <vector>

#include "core/settings.h"

namespace tessera {

/// The settings with the sizes of pieces, shapes and regions times the factor. Where every shape is to have a place the
/// range goes down to what the last attempt may need.
CollageSettings with_sizes_times(double factor, CollageSettings settings);

/// The factor at which the shapes that no given piece shows, each once, fill kFirstFilling of what given pieces leave
/// of the area.
/// `drawings`: for each shape the one that it is the mirror image of, mostly itself; empty: there are no mirror images.
double first_size_factor(const CollageSettings& settings, std::uint32_t library_shapes, double area_px2,
                         const std::vector<std::uint32_t>& drawings = {});

}  // namespace tessera
