#include "core/matching/matching_context.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/matching/sized_settings.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

/// Scales of a level that is not in use at the present sizes.
constexpr ScaleRange kNoScales{1e6f, 1e-6f};

PieceSettings of_sizes(const ScaleRange& scales_px, float factor) {
  return {.min_scale_px = scales_px.low * factor, .max_scale_px = scales_px.high * factor};
}

std::vector<int> levels_for(const PieceSettings& sizes) {
  return levels_for_scales(sizes.min_scale_px, sizes.max_scale_px, target_sigma_px(sizes));
}

/// Levels in use at all factors from 1 down to `least_factor`. A level serves an octave, so steps of half an octave
/// miss none.
std::vector<int> levels_down_to(float least_factor, const ScaleRange& scales_px) {
  constexpr float kHalfAnOctave = 0.70710678f;
  std::set<int> levels;
  const auto add = [&](float factor) {
    for (const int level : levels_for(of_sizes(scales_px, factor))) levels.insert(level);
  };
  for (float factor = 1; factor > least_factor; factor *= kHalfAnOctave) add(factor);
  add(least_factor);
  return {levels.begin(), levels.end()};
}

void set_sizes(MatchingContext& context, float size_factor) {
  const PieceSettings sizes = of_sizes(context.scales_px, size_factor);
  const std::vector<int> in_use = levels_for(sizes);
  context.max_scale_px = sizes.max_scale_px;
  context.gap_px = 2 * reachable_radius_px(sizes);
  context.colour_depth_px = 0.5f * std::sqrt(sizes.min_scale_px * sizes.max_scale_px);
  context.level_range.clear();
  for (const int level : context.levels) {
    const ScaleRange range = level_scales(level, target_sigma_px(sizes));
    const bool is_in_use = std::find(in_use.begin(), in_use.end(), level) != in_use.end();
    context.level_range.push_back(is_in_use ? ScaleRange{std::max(sizes.min_scale_px, range.low / kLevelSlack),
                                                         std::min(sizes.max_scale_px, range.high * kLevelSlack)}
                                            : kNoScales);
  }
}

}  // namespace

std::uint64_t pads_per_shape(const MatchingContext& context) {
  std::uint64_t pads = 0;
  for (const int level : context.levels) pads += std::uint64_t(kSmoothingLevels[level].samples);
  return pads;
}

Stance sized_at(const MatchingContext& context, const Stance& stance, Vec2 p_px) {
  return context.size_map ? with_sizes_up_to(context.size_map->at(p_px), stance) : stance;
}

MatchingContext make_matching_context(const CollageSettings& settings, std::uint32_t library_shapes) {
  const PieceSettings& pieces = settings.pieces;
  MatchingContext c;
  c.seed = settings.seed;
  c.pad = settings.match.pad;
  c.beta_steps = pad_steps(settings.match.beta);
  c.delta_px = settings.match.delta_px;
  c.stances = StanceTable(settings, library_shapes);
  c.scales_px = {pieces.min_scale_px, pieces.max_scale_px};
  c.hard_depth_px = hard_depth_px(pieces);
  c.tangent_dockings = settings.match.tangent_dockings;
  c.library_shapes = library_shapes;
  c.size_map = pieces.size_map;
  c.colour = settings.colour;
  c.levels = levels_down_to(least_size_factor(pieces), c.scales_px);
  set_sizes(c, 1);
  return c;
}

void limit(MatchingContext& context, const StanceTable& all, const StanceLimits& limits) {
  context.stances = all.limited(limits);
  set_sizes(context, limits.size_factor);
}

}  // namespace tessera
