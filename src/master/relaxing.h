// All pieces that stand move, turn and grow together into the gaps between them (core/relax), and come to lie where
// pieces may stand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/stop.h"
#include "core/collage/placement.h"
#include "core/field/free_field.h"
#include "core/matching/pose_range.h"
#include "core/relax/relaxation.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"

namespace tessera::master {

/// Where sizes differ more, dwarfs fill the gaps as well as pieces that grow into them (docs/decisions/2026-11-23-joint-relaxation.md).
inline constexpr float kMostRelaxedSizeRatio = 5;

enum class NoRelaxing {
  not_wanted,        // by the job
  sizes_by_place,    // they would not hold where a piece moved to
  colours_by_place,  // nor would these
  sizes_differ,      // more than kMostRelaxedSizeRatio
  sizes_fixed,       // no piece may grow
};

/// Nothing where relaxing pays.
std::optional<NoRelaxing> why_not_relaxed(const CollageSettings& settings);
bool pays_to_relax(const CollageSettings& settings);

/// About as many as there are pieces on so large a canvas, as it takes as much longer.
std::uint32_t trials_per_relaxation(double area_px2, const PieceSettings& pieces);

class Relaxing {
 public:
  using PosesOf = std::function<PoseRange(const Placement&)>;

  /// On the canvas of `free`, whatever lies in it. `poses_of`: what the pose of a piece may be. All but the settings
  /// outlive it.
  Relaxing(const FreeField& free, const CollageSettings& settings, ShapeSource& shapes, PosesOf poses_of);

  /// `placements` after all but the first `given` have moved, without those that found no place or came too near to
  /// their like. What `check_stop` throws leaves nothing changed.
  std::vector<Placement> relaxed(const std::vector<Placement>& placements, std::size_t given,
                                 std::span<const RelaxationSchedule> schedules, const StopCheck& check_stop);

 private:
  const FreeField& free_;
  CollageSettings settings_;
  ShapeSource& shapes_;
  PosesOf poses_of_;
  Relaxation relaxation_;
};

}  // namespace tessera::master
