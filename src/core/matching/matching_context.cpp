#include "core/matching/matching_context.h"

#include <cmath>

#include "core/tuning.h"

namespace tessera {

DirectionRange direction_range(float min_rad, float max_rad) {
  const double width_rad = double(max_rad) - double(min_rad);
  const double middle_rad = 0.5 * (double(min_rad) + double(max_rad));
  DirectionRange range;
  range.middle = {float(std::cos(middle_rad)), float(std::sin(middle_rad))};
  if (width_rad < 6.283) range.edge = {float(std::cos(0.5 * width_rad)), float(std::sin(0.5 * width_rad))};
  return range;
}

std::uint64_t pads_per_shape(const MatchingContext& context) {
  std::uint64_t pads = 0;
  for (const int level : context.levels) pads += std::uint64_t(kSmoothingLevels[level].samples);
  return pads;
}

MatchingContext make_matching_context(const CollageSettings& settings, std::uint32_t library_shapes) {
  const PieceSettings& pieces = settings.pieces;
  MatchingContext c;
  c.seed = settings.seed;
  c.pad = settings.match.pad;
  c.beta_steps = pad_steps(settings.match.beta);
  c.delta_px = settings.match.delta_px;
  c.poses = {pieces.min_scale_px, pieces.max_scale_px, direction_range(pieces.min_rotation_rad, pieces.max_rotation_rad)};
  c.docked_rotations =
      direction_range(pieces.min_rotation_rad - kDockingTurn_rad, pieces.max_rotation_rad + kDockingTurn_rad);
  c.gap_px = 2 * reachable_radius_px(pieces);
  c.log2_scale_ratio = std::log2(pieces.max_scale_px / pieces.min_scale_px);
  c.hard_depth_px = hard_depth_px(pieces);
  c.tangent_dockings = settings.match.tangent_dockings;
  c.library_shapes = library_shapes;
  c.levels = levels_for_scales(pieces.min_scale_px, pieces.max_scale_px, target_sigma_px(pieces));
  for (const int level : c.levels) {
    const ScaleRange range = level_scales(level, target_sigma_px(pieces));
    c.level_range.push_back(
        {std::max(pieces.min_scale_px, range.low / kLevelSlack), std::min(pieces.max_scale_px, range.high * kLevelSlack)});
  }
  return c;
}

}  // namespace tessera
