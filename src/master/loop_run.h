// One run of the loop: its limits, its progress and its checkpoints. The outline of the loop is in collage_loop.cpp.
#pragma once

#include "core/collage/loop_state.h"
#include "core/replacing/own_replacer.h"
#include "master/collage_loop.h"
#include "master/loop_end.h"
#include "master/loop_statistics.h"
#include "master/regions.h"

namespace tessera::master {

class LoopRun {
 public:
  /// Takes the arguments of make_collage, which outlive the run. Begins the first region, or goes on from the checkpoint.
  LoopRun(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes,
          Observer& observer, const Checkpoints& checkpoints, Replacer* replacer);
  LoopRun(const LoopRun&) = delete;  // its parts refer to each other
  LoopRun& operator=(const LoopRun&) = delete;

  bool is_filling() const { return state_.phase == LoopPhase::filling; }
  Regions& regions() { return regions_; }
  LoopEnd& end() { return end_; }
  bool place_one() { return regions_.current().filling.place_one(); }

  /// Whether an earlier result gave as many pieces as the job wants. Then they are only improved.
  bool moves_given_pieces_only() const;
  /// Whether an attempt at sizes has nothing more to show: all wanted pieces stand, or the canvas is covered. False where
  /// no other sizes may be tried.
  bool attempt_is_decided() const;
  bool end_at_limit_of_filling();
  /// Ends the filling of the region: improving begins where the job wants it.
  void end_filling();
  /// Improves the full region until the trials of the job are used up (improving_phase.h). A run from a checkpoint may
  /// begin here; it then finds out again why the region is full.
  void improve();
  /// Begins the next region. False where there is none or the loop is over.
  bool begin_next_region();

  /// Reports the progress, and keeps a checkpoint where one is due.
  void after_step();
  /// Keeps the last checkpoint and returns the result.
  CollageResult finish();

 private:
  Collage& collage() const { return regions_.current().collage; }
  StopReason why_full() const;
  CheckpointState checkpoint();

  LoopStatistics statistics_;  // the first member: the time of set-up begins with it
  const Canvas& canvas_;
  const CollageSettings& settings_;
  ShapeSource& shapes_;
  Observer& observer_;
  CheckpointKeeper* keeper_;
  LoopState state_;
  Regions regions_;  // before end_, whose clock must not count the set-up
  LoopEnd end_;
  OwnReplacer own_replacer_;
  Replacer& replacer_;
};

}  // namespace tessera::master
