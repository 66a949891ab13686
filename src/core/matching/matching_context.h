// Numbers that matching, docking and refinement share. Every rank computes the same ones once from the settings.
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
  ScaleRange scales_px{};   // of all stances, at size factor 1
  float max_scale_px = 0;   // of all stances, at the present size factor
  float hard_depth_px = 0;  // no boundary point of a piece lies deeper in another piece
  float gap_px = 0;         // boundary points up to this far from others count as gap
  int tangent_dockings = 0;
  std::uint32_t library_shapes = 0;
  std::shared_ptr<const SizeMap> size_map;  // empty: all sizes everywhere
  ColourWish colour;
  float colour_depth_px = 0;            // for NearColours: half the size of a medium piece
  std::vector<int> levels;              // smoothing levels in use at any size factor
  std::vector<ScaleRange> level_range;  // scales that each level serves, slack included, px; low above high: none
};

/// The number of PADs of a shape over all levels in use, the same for every shape.
std::uint64_t pads_per_shape(const MatchingContext& context);

/// The stance with only the sizes that the size map allows at the place `p_px`.
Stance sized_at(const MatchingContext& context, const Stance& stance, Vec2 p_px);

/// Makes the context from the settings. With fit = "all" it has the levels of every size factor from 1 down to
/// least_size_factor, so that one matcher serves all factors.
MatchingContext make_matching_context(const CollageSettings& settings, std::uint32_t library_shapes);

/// Limits the context, whose whole table of stances is `all`. Sets the stances that may stand and all numbers that
/// follow from the sizes at `limits.size_factor`.
void limit(MatchingContext& context, const StanceTable& all, const StanceLimits& limits);

}  // namespace tessera
