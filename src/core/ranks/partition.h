// Dividing a library among ranks, and a rank's part among its devices; and work among those who do it.
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

/// Divides items 0 .. items - 1 in proportion to the speeds of those who get them (at least one; all above 0): ranges
/// that follow one another. None has more than its share and one item; none is empty as long as there are items enough,
/// however slow it is, otherwise the last ones are. With `most`, one number for each part, no part gets more than that
/// many items: the others share what it cannot take, in proportion to their speeds. Throws std::invalid_argument where
/// all parts together cannot take all items.
std::vector<ShapeRange> ranges_by_speed(std::size_t items, std::span<const double> speeds,
                                        std::span<const std::size_t> most = {});

/// Divides items among parts, of which part p works on `breadths[p]` (at least 1) items at a time: the heaviest ones
/// first, each to the part with the least weight for its breadth, of equal ones to the first. Gives the items of each
/// part in that order. No part has more than its share of all weight, in proportion to its breadth, and the heaviest
/// item together.
std::vector<std::vector<std::size_t>> fair_shares(std::span<const std::uint64_t> weights,
                                                  std::span<const int> breadths);

}  // namespace tessera
