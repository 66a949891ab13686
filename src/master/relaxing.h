// Relaxes all pieces of a collage: they move, turn and grow together into the gaps between them (core/relax). Then it
// brings them to poses where their outlines are clear of each other.
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

/// The largest ratio of sizes with which pieces relax. With a larger one, dwarfs fill the gaps as well
/// (docs/decisions/2026-11-23-joint-relaxation.md).
inline constexpr float kMostRelaxedSizeRatio = 5;

enum class NoRelaxing {
  not_wanted,        // the job switches it off
  sizes_by_place,    // sizes depend on the place: a piece that moves would have a wrong one
  colours_by_place,  // colours depend on the place, too
  sizes_differ,      // more than kMostRelaxedSizeRatio
  sizes_fixed,       // no piece may grow
};

/// Why relaxing does not pay. Empty where it does.
std::optional<NoRelaxing> why_not_relaxed(const CollageSettings& settings);
bool pays_to_relax(const CollageSettings& settings);

/// Relaxing is due once in so many trials. The number is about the number of pieces on the canvas, because relaxing takes
/// so much longer than another trial.
std::uint32_t trials_per_relaxation(double area_px2, const PieceSettings& pieces);

class Relaxing {
 public:
  using PosesOf = std::function<PoseRange(const Placement&)>;

  /// Relaxes pieces on the canvas of `free`; the pieces that lie in `free` do not matter. `poses_of`: the poses that a
  /// piece may have. All arguments but the settings outlive this object.
  Relaxing(const FreeField& free, const CollageSettings& settings, ShapeSource& shapes, PosesOf poses_of);

  /// `placements` after all but the first `given` have moved. Pieces that found no place, or came too near to their like,
  /// are left out. Where `check_stop` throws, nothing has changed.
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
