// Divides a library among ranks, a rank's part among its devices, and work among workers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/shape/shape_id.h"

namespace tessera {

/// Divides items 0 .. weights.size() - 1 into `parts` (at least 1) successive ranges. No range weighs more than the
/// average and the heaviest item together. No range is empty if there are enough items; otherwise the last ones are
/// empty.
std::vector<ShapeRange> balanced_ranges(std::span<const std::uint64_t> weights, int parts);

/// Range `part` of `parts` if every shape weighs the same. The sizes of the ranges differ by at most one.
ShapeRange even_range(std::size_t shapes, int part, int parts);

/// Divides items 0 .. items - 1 into successive ranges in proportion to `speeds` (at least one; all above 0). No range
/// has more than its share and one item. No range is empty if there are enough items, however slow its part is;
/// otherwise the last ones are empty. `most`, if given, limits the items of each part; the other parts share the rest
/// in proportion to their speeds. Throws std::invalid_argument if all parts together cannot take all items.
std::vector<ShapeRange> ranges_by_speed(std::size_t items, std::span<const double> speeds,
                                        std::span<const std::size_t> most = {});

/// Divides items among parts; part p works on `breadths[p]` (at least 1) items at a time. The heaviest items come
/// first; each goes to the part with the least weight for its breadth, among equals to the first. Returns the items of
/// each part in that order. No part has more than its share of the weight, in proportion to its breadth, and the
/// heaviest item together.
std::vector<std::vector<std::size_t>> fair_shares(std::span<const std::uint64_t> weights,
                                                  std::span<const int> breadths);

}  // namespace tessera
