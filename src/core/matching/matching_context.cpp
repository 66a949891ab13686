#include "core/matching/matching_context.h"

#include <algorithm>
#include <cmath>

#include "core/tuning.h"

namespace tessera {

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
  c.max_scale_px = pieces.max_scale_px;
  c.gap_px = 2 * reachable_radius_px(pieces);
  c.hard_depth_px = hard_depth_px(pieces);
  c.tangent_dockings = settings.match.tangent_dockings;
  c.library_shapes = library_shapes;
  c.size_map = pieces.size_map;
  c.colour = settings.colour;
  c.colour_depth_px = 0.5f * std::sqrt(pieces.min_scale_px * pieces.max_scale_px);
  c.levels = levels_for_scales(pieces.min_scale_px, pieces.max_scale_px, target_sigma_px(pieces));
  for (const int level : c.levels) {
    const ScaleRange range = level_scales(level, target_sigma_px(pieces));
    c.level_range.push_back({std::max(pieces.min_scale_px, range.low / kLevelSlack),
                             std::min(pieces.max_scale_px, range.high * kLevelSlack)});
  }
  return c;
}

}  // namespace tessera
