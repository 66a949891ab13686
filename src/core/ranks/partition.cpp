#include "core/ranks/partition.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace tessera {
namespace {

/// Running sums: weight_before[i] is the weight of items 0 .. i - 1.
std::vector<std::uint64_t> running_sums(std::span<const std::uint64_t> weights) {
  std::vector<std::uint64_t> weight_before{0};
  for (const std::uint64_t weight : weights) weight_before.push_back(weight_before.back() + weight);
  return weight_before;
}

/// The index i for which weight_before[i] is nearest to `goal`.
std::size_t nearest_border(const std::vector<std::uint64_t>& weight_before, std::uint64_t goal) {
  const auto above = std::lower_bound(weight_before.begin(), weight_before.end(), goal);
  if (above == weight_before.begin()) return 0;
  const bool below_is_nearer = goal - above[-1] < *above - goal;
  return std::size_t(above - weight_before.begin()) - (below_is_nearer ? 1 : 0);
}

/// The end of a part that begins at `begin`: as near to `goal` as possible while this part and each of the `parts_left`
/// after it get an item. The last part ends with the items.
std::size_t end_near(std::size_t goal, std::size_t begin, std::size_t items, std::size_t parts_left) {
  if (parts_left == 0) return items;
  const std::size_t latest = items > parts_left ? items - parts_left : 0;
  return std::max(std::min(goal, latest), std::min(begin + 1, items));
}

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

/// Shares by speed. A part whose share would exceed its limit gets the limit, and the others share the rest.
std::vector<double> limited_shares(std::size_t items, std::span<const double> speeds,
                                   const std::vector<std::size_t>& limits) {
  std::vector<double> shares(speeds.size(), 0);
  std::vector<bool> is_full(speeds.size(), false);
  for (bool found_full = true; found_full;) {
    double left = double(items);
    double speed = 0;
    for (std::size_t p = 0; p < speeds.size(); ++p) (is_full[p] ? left : speed) += is_full[p] ? -shares[p] : speeds[p];
    found_full = false;
    for (std::size_t p = 0; p < speeds.size(); ++p) {
      if (is_full[p]) continue;
      shares[p] = left * (speeds[p] / speed);
      if (shares[p] <= double(limits[p])) continue;
      shares[p] = double(limits[p]);
      is_full[p] = found_full = true;
    }
  }
  return shares;
}

/// Whole numbers whose running sums are as near to those of the shares as possible while each part gets an item.
std::vector<std::size_t> rounded_sizes(const std::vector<double>& shares, std::size_t items) {
  std::vector<std::size_t> sizes;
  double sum = 0;
  std::size_t begin = 0;
  for (std::size_t p = 0; p < shares.size(); ++p) {
    sum += shares[p];
    const std::size_t end = end_near(std::size_t(std::llround(sum)), begin, items, shares.size() - 1 - p);
    sizes.push_back(end - begin);
    begin = end;
  }
  return sizes;
}

/// Moves items beyond a part's limit, which rounding or the least of one item caused, to the first parts with room.
void move_excess(const std::vector<std::size_t>& limits, std::vector<std::size_t>& sizes) {
  std::size_t excess = 0;
  for (std::size_t p = 0; p < sizes.size(); ++p) {
    const std::size_t kept = std::min(sizes[p], limits[p]);
    excess += std::exchange(sizes[p], kept) - kept;
  }
  for (std::size_t p = 0; p < sizes.size(); ++p) {
    const std::size_t more = std::min(excess, limits[p] - sizes[p]);
    sizes[p] += more;
    excess -= more;
  }
}

}  // namespace

std::vector<ShapeRange> balanced_ranges(std::span<const std::uint64_t> weights, int parts) {
  if (parts < 1) throw std::invalid_argument("balanced_ranges: at least one part is needed");
  const std::vector<std::uint64_t> weight_before = running_sums(weights);
  const std::uint64_t total = weight_before.back();
  const std::size_t items = weights.size();
  std::vector<ShapeRange> ranges;
  std::size_t begin = 0;
  for (int p = 1; p <= parts; ++p) {
    const std::uint64_t goal = total / parts * p + total % parts * p / parts;
    const std::size_t end = end_near(nearest_border(weight_before, goal), begin, items, std::size_t(parts - p));
    ranges.push_back({std::uint32_t(begin), std::uint32_t(end)});
    begin = end;
  }
  return ranges;
}

ShapeRange even_range(std::size_t shapes, int part, int parts) {
  const std::vector<std::uint64_t> weights(shapes, 1);
  return balanced_ranges(weights, parts)[std::size_t(part)];
}

std::vector<ShapeRange> ranges_by_speed(std::size_t items, std::span<const double> speeds,
                                        std::span<const std::size_t> most) {
  const auto usable = [](double speed) { return speed > 0 && std::isfinite(speed); };
  if (speeds.empty() || !std::all_of(speeds.begin(), speeds.end(), usable)) {
    throw std::invalid_argument("ranges_by_speed: at least one part is needed, and speeds above 0");
  }
  const std::vector<std::size_t> limits = most.empty() ? std::vector<std::size_t>(speeds.size(), items)
                                                       : std::vector<std::size_t>(most.begin(), most.end());
  const auto room = [](std::size_t sum, std::size_t limit) { return sum + std::min(limit, kNoLimit - sum); };
  if (limits.size() != speeds.size() || std::accumulate(limits.begin(), limits.end(), std::size_t(0), room) < items) {
    throw std::invalid_argument("ranges_by_speed: no room for all items");
  }
  std::vector<std::size_t> sizes = rounded_sizes(limited_shares(items, speeds, limits), items);
  move_excess(limits, sizes);
  std::vector<ShapeRange> ranges;
  std::size_t begin = 0;
  for (const std::size_t size : sizes) {
    ranges.push_back({std::uint32_t(begin), std::uint32_t(begin + size)});
    begin += size;
  }
  return ranges;
}

std::vector<std::vector<std::size_t>> fair_shares(std::span<const std::uint64_t> weights,
                                                  std::span<const int> breadths) {
  if (breadths.empty()) throw std::invalid_argument("fair_shares: at least one part is needed");
  std::vector<std::size_t> heaviest_first(weights.size());
  std::iota(heaviest_first.begin(), heaviest_first.end(), std::size_t(0));
  std::stable_sort(heaviest_first.begin(), heaviest_first.end(),
                   [&](std::size_t a, std::size_t b) { return weights[a] > weights[b]; });
  std::vector<std::vector<std::size_t>> shares(breadths.size());
  std::vector<std::uint64_t> load(breadths.size(), 0);
  for (const std::size_t item : heaviest_first) {
    std::size_t least = 0;
    for (std::size_t p = 1; p < breadths.size(); ++p) {
      if (load[p] * std::uint64_t(breadths[least]) < load[least] * std::uint64_t(breadths[p])) least = p;
    }
    shares[least].push_back(item);
    load[least] += weights[item];
  }
  return shares;
}

}  // namespace tessera
