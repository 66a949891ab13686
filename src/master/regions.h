// The regions of the canvas, filled one after another. With fit = "all" each region is filled in several attempts at
// different sizes, until every wanted piece finds a place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/run_statistics.h"
#include "core/base/stop.h"
#include "core/collage/checkpoint_state.h"
#include "core/field/canvas.h"
#include "core/matching/matcher.h"
#include "core/matching/matching_context.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"
#include "master/collage.h"
#include "master/filling.h"
#include "master/rules/standing_pieces.h"
#include "master/size_attempts.h"

namespace tessera::master {

/// The collage while a region is filled, at the sizes of one attempt.
struct RegionFill {
  RegionFill(const Canvas& region, const CollageSettings& settings, const MatchingContext& context, float size_factor,
             Matcher& matcher, ShapeSource& shapes, RunStatistics& statistics, StopCheck check_stop);

  CollageSettings sized;  // settings with the sizes of this attempt
  Collage collage;
  Filling filling;
};

class Regions {
 public:
  /// Filling adds to `statistics` and calls `check_stop`, which may throw. All arguments outlive the attempts.
  Regions(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes,
          RunStatistics& statistics, StopCheck check_stop);

  /// The present attempt. Call begin_first() or restore() before.
  RegionFill& current() const { return *current_; }
  /// The number of the present attempt, from 1. All regions share the attempts.
  int attempt_number() const { return sizes_.number(); }
  const GivenPieces& given() const { return given_; }

  void begin_first();
  /// Begins the next region with all pieces that stand. False where there is no other region.
  bool begin_next();
  /// Ends the present attempt and begins one at other sizes, or goes back to the best attempt. False where it does neither:
  /// the region stays as it is.
  bool begin_other_sizes();
  /// Goes back to the best attempt, because a limit of the job ends all attempts.
  void keep_best();
  /// Whether other sizes may be tried.
  bool may_try_other_sizes() const { return !sizes_.over(); }

  /// Adds the state of the collage and of the attempts.
  void save(CheckpointState& state) const;
  /// Goes on from the saved state. Throws InputError where it belongs to another job, canvas or library.
  void restore(const CheckpointState& from);

 private:
  std::uint32_t region() const { return current_->collage.open_shapes().limits().region; }
  void begin(std::uint32_t region, StandingPieces standing, const SizeAttempts& sizes);
  void begin_again(std::uint32_t region, std::vector<Placement> placements, std::size_t given,
                   const SizeAttempts& sizes);
  bool go_back_to_best(SizeAttempts sizes);
  void check_belongs(const CheckpointState& from) const;
  std::uint64_t begun_with() const;

  const Canvas& canvas_;
  const CollageSettings& settings_;
  Matcher& matcher_;
  ShapeSource& shapes_;
  RunStatistics& statistics_;
  StopCheck check_stop_;
  MatchingContext context_;
  SizeAttempts sizes_;
  GivenPieces given_;
  std::unique_ptr<RegionFill> current_;
};

}  // namespace tessera::master
