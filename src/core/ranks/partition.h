// Dividing a library among ranks, and a rank's part among its devices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/shape/shape_id.h"

namespace tessera {

/// Divides items 0 .. weights.size() - 1 into `parts` (at least 1) ranges that follow one another. No range weighs more
/// than the average and the heaviest item together; none is empty as long as there are items enough, otherwise the last
/// ones are.
std::vector<ShapeRange> balanced_ranges(std::span<const std::uint64_t> weights, int parts);

/// Range `part` of `parts` where every shape weighs the same: their sizes differ by one at most.
ShapeRange even_range(std::size_t shapes, int part, int parts);

}  // namespace tessera
