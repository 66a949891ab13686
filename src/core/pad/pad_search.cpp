#include "core/pad/pad_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera {
namespace {

constexpr float kNotMet = std::numeric_limits<float>::infinity();
/// The middle of the elements that have this byte (pad_byte).
float element_of(std::uint8_t byte) { return (float(byte) + 0.5f) * (1.f / 256); }

/// The elements of a PAD that belong to one side, and the target's values for them.
struct Side {
  const std::array<float, kMaxPadLevels>& wanted;
  int known;      // levels
  int levels;     // of the PADs
  int direction;  // -1: left

  int elements() const { return known - 1; }
  int element(int level) const { return direction < 0 ? levels - 2 - level : levels - 1 + level; }
  /// Whether lengths must be divided by an element. If all levels are known, the divisor is the longest level, which is
  /// 1.
  bool divided() const { return known < levels; }
};

std::array<Side, 2> sides_of(const PadTarget& target, int levels) {
  return {Side{target.left, target.left_levels, levels, -1}, Side{target.right, target.right_levels, levels, +1}};
}

using Row = std::array<std::uint8_t, kIndexFanOut>;

/// One over the length of the side's last known level, for 64 PADs; 1 if all levels are known.
std::array<float, kIndexFanOut> inverse_lengths(const std::array<Row, kMaxPadElements>& elements, const Side& side) {
  std::array<float, kIndexFanOut> inverse;
  inverse.fill(1);
  if (!side.divided()) return inverse;
  const Row& last = elements[std::size_t(side.element(side.known - 1))];
  const float weight = float(1 << (side.known - 1));  // the inverse of the factor in make_pad()
  for (std::size_t i = 0; i < kIndexFanOut; ++i) inverse[i] = 1 / (weight * element_of(last[i]));
  return inverse;
}

}  // namespace

PadTarget make_pad_target(const ArclengthPyramid& pyramid, int left_levels, int right_levels) {
  PadTarget target;
  target.left_levels = left_levels;
  target.right_levels = right_levels;
  const auto fill = [](std::array<float, kMaxPadLevels>& side, const std::array<float, kMaxPadLevels>& length,
                       int known) {
    float weight = 1;
    for (int i = 0; i + 1 < known; ++i, weight *= 0.5f) {
      side[std::size_t(i)] = weight * length[std::size_t(i)] / length[std::size_t(known - 1)];
    }
  };
  fill(target.left, pyramid.left, left_levels);
  fill(target.right, pyramid.right, right_levels);
  target.sign = sign_byte(pyramid.convexity);
  return target;
}

PadSearch::PadSearch(const PadIndex& index, std::span<const PadBytes> pads, int levels)
    : levels_(levels),
      order_(index.order),
      pads_(index.blocks.size(), PadRows{}),
      blocks_(rows_of(index.blocks)),
      nodes_(rows_of(index.nodes)) {
  for (std::size_t i = 0; i < order_.size(); ++i) {
    PadRows& rows = pads_[i / kIndexFanOut];
    const PadBytes& pad = pads[order_[i]];
    for (std::size_t e = 0; e < pad.element.size(); ++e) rows.element[e][i % kIndexFanOut] = pad.element[e];
    rows.scale[i % kIndexFanOut] = pad.scale;
    rows.sign[i % kIndexFanOut] = pad.sign;
  }
}

std::vector<PadSearch::BoxRows> PadSearch::rows_of(const std::vector<PadBox>& boxes) {
  std::vector<BoxRows> all((boxes.size() + kIndexFanOut - 1) / kIndexFanOut, BoxRows{});
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    BoxRows& rows = all[i / kIndexFanOut];
    const std::size_t lane = i % kIndexFanOut;
    for (std::size_t e = 0; e < boxes[i].low.size(); ++e) {
      rows.low[e][lane] = boxes[i].low[e];
      rows.high[e][lane] = boxes[i].high[e];
    }
    rows.scale_low[lane] = boxes[i].scale_low;
    rows.scale_high[lane] = boxes[i].scale_high;
    rows.signs[lane] = boxes[i].signs;
  }
  return all;
}

void PadSearch::measure(const PadRows& rows, const PadTarget& target, Distances& distance) const {
  for (std::size_t i = 0; i < kIndexFanOut; ++i) {
    const bool met =
        (rows.sign[i] & target.sign) != 0 && rows.scale[i] >= target.scales.low && rows.scale[i] <= target.scales.high;
    distance[i] = met ? 0 : kNotMet;
  }
  for (const Side& side : sides_of(target, levels_)) {
    const Distances inverse = inverse_lengths(rows.element, side);
    for (int level = 0; level < side.elements(); ++level) {
      const Row& element = rows.element[std::size_t(side.element(level))];
      const float wanted = side.wanted[std::size_t(level)];
      for (std::size_t i = 0; i < kIndexFanOut; ++i) {
        distance[i] = std::max(distance[i], std::abs(element_of(element[i]) * inverse[i] - wanted));
      }
    }
  }
}

/// A lower bound of the distances of the PADs in each box. It applies the operations of measure() to the ends of
/// intervals. Each operation is monotone, rounding included, so no bound lies above a distance.
void PadSearch::bound(const BoxRows& rows, const PadTarget& target, Distances& distance) const {
  for (std::size_t i = 0; i < kIndexFanOut; ++i) {
    const bool met = (rows.signs[i] & target.sign) != 0 && rows.scale_high[i] >= target.scales.low &&
                     rows.scale_low[i] <= target.scales.high;
    distance[i] = met ? 0 : kNotMet;
  }
  for (const Side& side : sides_of(target, levels_)) {
    const Distances largest = inverse_lengths(rows.low, side);
    const Distances least = inverse_lengths(rows.high, side);
    for (int level = 0; level < side.elements(); ++level) {
      const auto element = std::size_t(side.element(level));
      const float wanted = side.wanted[std::size_t(level)];
      for (std::size_t i = 0; i < kIndexFanOut; ++i) {
        const float above = element_of(rows.low[element][i]) * least[i] - wanted;
        const float below = wanted - element_of(rows.high[element][i]) * largest[i];
        distance[i] = std::max(distance[i], std::max(above, below));
      }
    }
  }
}

namespace {

/// The nearest hits so far, at most `most` of them.
class Nearest {
 public:
  Nearest(float reach, std::size_t most) : below_reach_(std::nextafter(reach, 0.f)), most_(most) {}

  /// Hits farther away are not among the nearest; hits at this distance may be.
  float farthest() const { return hits_.size() < most_ ? below_reach_ : hits_.front().distance; }
  void take(const PadHit& hit) {
    if (hits_.size() == most_) {
      if (!(hit < hits_.front())) return;
      std::pop_heap(hits_.begin(), hits_.end());
      hits_.pop_back();
    }
    hits_.push_back(hit);
    std::push_heap(hits_.begin(), hits_.end());
  }
  std::vector<PadHit> sorted() && {
    std::sort_heap(hits_.begin(), hits_.end());
    return std::move(hits_);
  }

 private:
  float below_reach_;
  std::size_t most_;
  std::vector<PadHit> hits_;
};

/// A loop without branches, as few blocks contain any.
bool any_within(const std::array<float, kIndexFanOut>& distances, float limit) {
  int within = 0;
  for (const float distance : distances) within |= distance <= limit;
  return within != 0;
}

struct NearBlock {
  float distance;
  std::uint32_t block;
};

}  // namespace

std::vector<PadHit> PadSearch::nearest(const PadTarget& target, float reach, std::size_t most,
                                       const std::function<bool(std::uint32_t place)>& wanted) const {
  if (most == 0) return {};
  Distances distance;
  std::vector<NearBlock> near;
  for (std::size_t group = 0; group < nodes_.size(); ++group) {
    bound(nodes_[group], target, distance);
    const Distances of_nodes = distance;
    for (std::size_t i = 0; i < kIndexFanOut; ++i) {
      if (!(of_nodes[i] < reach)) continue;
      const std::size_t node = group * kIndexFanOut + i;
      bound(blocks_[node], target, distance);
      for (std::size_t k = 0; k < kIndexFanOut; ++k) {
        if (distance[k] < reach) near.push_back({distance[k], std::uint32_t(node * kIndexFanOut + k)});
      }
    }
  }
  // The nearest block is on top of a heap. Few blocks are visited, so sorting all would take longer.
  const auto farther = [](const NearBlock& a, const NearBlock& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.block > b.block;
  };
  std::make_heap(near.begin(), near.end(), farther);
  Nearest hits(reach, most);
  for (; !near.empty(); near.pop_back()) {
    std::pop_heap(near.begin(), near.end(), farther);
    const NearBlock& block = near.back();
    if (block.distance > hits.farthest()) break;
    measure(pads_[block.block], target, distance);
    if (!any_within(distance, hits.farthest())) continue;
    for (std::size_t i = 0; i < kIndexFanOut; ++i) {
      if (distance[i] > hits.farthest()) continue;
      const std::uint32_t place = order_[std::size_t(block.block) * kIndexFanOut + i];
      if (wanted(place)) hits.take({distance[i], place});
    }
  }
  return std::move(hits).sorted();
}

}  // namespace tessera
