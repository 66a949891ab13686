// The numbers that matching, docking and refinement share, computed once from the settings on every rank alike.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/colour/colour_wish.h"
#include "core/matching/stances.h"
#include "core/settings/settings.h"
#include "core/shape/shape_model.h"

namespace tessera {

struct MatchingContext {
  std::uint64_t seed = 1;
  PadParameters pad;
  std::uint32_t beta_steps = 0;  // pad_steps(beta)
  float delta_px = 0;
  StanceTable stances;
  ScaleRange scales_px{};   // of all stances at size factor 1
  float max_scale_px = 0;   // of all stances
  float hard_depth_px = 0;  // no boundary point of a piece lies deeper in another
  float gap_px = 0;         // boundary points up to this far from others count as gap
  int tangent_dockings = 0;
  std::uint32_t library_shapes = 0;
  std::shared_ptr<const SizeMap> size_map;  // none: all sizes everywhere
  ColourWish colour;
  float colour_depth_px = 0;            // NearColours: half a piece of middle size
  std::vector<int> levels;              // smoothing levels in use, at this or another size factor
  std::vector<ScaleRange> level_range;  // scales that each of them serves, slack included, px; none: low above high
};

/// The number of PADs of a shape over all levels in use, the same for every shape.
std::uint64_t pads_per_shape(const MatchingContext& context);

/// The stance with the sizes that the map leaves of it at a place.
Stance sized_at(const MatchingContext& context, const Stance& stance, Vec2 p_px);

/// With fit = "all" it has the levels of every size factor from 1 down to the least (least_size_factor), so that a
/// matcher that was made for it is ready for each of them.
MatchingContext make_matching_context(const CollageSettings& settings, std::uint32_t library_shapes);

/// Brings the context, whose whole table of stances is `all`, within the limits: what may stand, and all that follows
/// from the sizes at `limits.size_factor`.
void limit(MatchingContext& context, const StanceTable& all, const StandingLimits& limits);

}  // namespace tessera
