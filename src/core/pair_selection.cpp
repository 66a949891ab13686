#include "core/pair_selection.h"

#include <algorithm>

#include "core/tuning.h"

namespace tessera {
namespace {

constexpr float kNoPair = 9.f;

/// The level whose interval estimates the scale before any alignment.
int scale_level(int levels) { return std::min(2, levels - 1); }

/// Distances of one level's PADs; kNoPair where the scale or the sign cannot fit.
std::vector<float> level_distances(const ModelLevel& level, const Pad& target, float target_length,
                                   const ScaleRange& scales, int levels) {
  const int k = scale_level(levels);
  std::vector<float> result(level.pads.size(), kNoPair);
  for (std::size_t j = 0; j < level.pads.size(); ++j) {
    const float length = level.samples[j].left[k] + level.samples[j].right[k];
    if (target_length < length * (scales.low * kScaleWindowLow)) continue;
    if (target_length > length * (scales.high * kScaleWindowHigh)) continue;
    if (target.convexity * level.pads[j].convexity < 0) continue;
    result[j] = pad_distance(target, level.pads[j], levels);
  }
  return result;
}

bool better(const PadPair& a, const PadPair& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.source < b.source;
}

void keep_best(std::vector<PadPair>& pairs, const PadPair& pair) {
  pairs.insert(std::upper_bound(pairs.begin(), pairs.end(), pair, better), pair);
  if (pairs.size() > kPairsPerShape) pairs.pop_back();
}

}  // namespace

std::vector<PadPair> select_pairs(const ShapeModel& shape, const TargetSample& sample,
                                  const MatchingContext& context) {
  const int levels = context.pad.levels;
  const Pad target = make_pad(sample.pyramid, levels);
  const int k = scale_level(levels);
  const float target_length = sample.pyramid.left[k] + sample.pyramid.right[k];
  std::vector<PadPair> pairs;
  std::uint32_t first = 0;
  for (std::size_t slot = 0; slot < shape.levels.size(); ++slot) {
    const std::vector<float> distance =
        level_distances(shape.levels[slot], target, target_length, context.level_range[slot], levels);
    const std::size_t n = distance.size();
    for (std::size_t j = 0; j < n; ++j) {
      const float d = distance[j];
      if (d >= context.beta || d > distance[j == 0 ? n - 1 : j - 1] || d >= distance[j + 1 == n ? 0 : j + 1]) continue;
      keep_best(pairs, {first + std::uint32_t(j), d});
    }
    first += std::uint32_t(n);
  }
  return pairs;
}

SourceLocation locate_source(const ShapeModel& shape, std::uint32_t source) {
  int slot = 0;
  while (source >= shape.levels[slot].pads.size()) source -= std::uint32_t(shape.levels[slot++].pads.size());
  return {slot, int(source)};
}

}  // namespace tessera
