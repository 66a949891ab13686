// Checks the limits of the library format (docs/library-format.md) on a shape before it is written. The reader checks the
// same limits column by column.
#pragma once

#include <cstddef>

#include "core/shape/shape.h"
#include "core/style/style_features.h"

namespace tessera {

/// Whether all `count` numbers from `values` on are finite and within [least, most].
bool all_within(const float* values, std::size_t count, float least, float most);
/// Whether the numbers of the style are in the ranges of docs/library-format.md.
bool is_style(const StyleFeatures& style);
bool all_within(const Vec2* values, std::size_t count, float least, float most);

/// Throws InputError that names the shape, its artwork and the limit.
void check_fits_library(const Shape& shape, const StyleFeatures& style);

}  // namespace tessera
