#include "core/matching/pair_selection.h"

#include <algorithm>

#include "core/pad/pad_filter.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

constexpr std::uint32_t kNoPair = 2 * kPadSteps;

struct Target {
  QuantisedPad pad;
  float length;
  float convexity;
  Vec2 chord;
};

bool may_turn(Vec2 chord, const Target& target, std::span<const Stance> stances) {
  const Vec2 turn{dot(chord, target.chord), cross(chord, target.chord)};
  return std::any_of(stances.begin(), stances.end(),
                     [&](const Stance& s) { return s.docked_rotations.contains(turn, 1, 0); });
}

/// PAD distances of one level's samples; kNoPair where the scale, the sign or the rotation cannot fit.
std::vector<std::uint32_t> level_distances(const ModelLevel& level, const Target& target, const ScaleRange& scales,
                                           std::span<const Stance> stances, const MatchingContext& context) {
  const int levels = context.pad.levels;
  std::vector<std::uint32_t> result(level.samples.size(), kNoPair);
  for (std::size_t j = 0; j < level.samples.size(); ++j) {
    const ModelSample& sample = level.samples[j];
    if (target.length < sample.scale_length * (scales.low * kScaleWindowLow)) continue;
    if (target.length > sample.scale_length * (scales.high * kScaleWindowHigh)) continue;
    if ((sign_byte(target.convexity) & sign_byte(sample.convexity)) == 0) continue;
    if (!may_turn(chord(sample, levels), target, stances)) continue;
    result[j] = pad_distance(target.pad, sample.pad, levels);
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

std::vector<PadPair> select_pairs(const ShapeModel& shape, const TargetSample& sample, const StanceList& list,
                                  const MatchingContext& context, std::uint32_t reach_steps) {
  if (list.count == 0) return {};
  const int levels = context.pad.levels;
  const Target target{quantised(make_pad(sample.pyramid, levels)), scale_length(sample.pyramid, levels),
                      sample.pyramid.convexity, chord(sample.pyramid, levels)};
  std::vector<PadPair> pairs;
  std::uint32_t first = 0;
  for (std::size_t slot = 0; slot < shape.levels.size(); ++slot) {
    const ScaleRange served = context.level_range[slot];
    const ScaleRange scales{std::max(served.low, list.min_scale_px), std::min(served.high, list.max_scale_px)};
    const std::vector<std::uint32_t> distance =
        level_distances(shape.levels[slot], target, scales, context.stances.of(list), context);
    const std::size_t n = distance.size();
    for (std::size_t j = 0; j < n; ++j) {
      const std::uint32_t d = distance[j];
      if (d >= reach_steps || d > distance[j == 0 ? n - 1 : j - 1] || d >= distance[j + 1 == n ? 0 : j + 1]) continue;
      keep_best(pairs, {first + std::uint32_t(j), d});
    }
    first += std::uint32_t(n);
  }
  return pairs;
}

SourceLocation locate_source(const std::vector<int>& levels, std::uint32_t source) {
  int slot = 0;
  const auto samples = [&] { return std::uint32_t(kSmoothingLevels[std::size_t(levels[std::size_t(slot)])].samples); };
  for (; source >= samples(); ++slot) source -= samples();
  return {slot, int(source)};
}

}  // namespace tessera
