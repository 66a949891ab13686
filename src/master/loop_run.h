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
  /// The arguments of make_collage, which outlive the run. It begins the first region, or where a checkpoint left off.
  LoopRun(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes,
          Observer& observer, const Checkpoints& checkpoints, Replacer* replacer);
  LoopRun(const LoopRun&) = delete;  // its parts refer to each other
  LoopRun& operator=(const LoopRun&) = delete;

  bool is_filling() const { return state_.phase == LoopPhase::filling; }
  Regions& regions() { return regions_; }
  LoopEnd& end() { return end_; }
  bool place_one() { return regions_.current().filling.place_one(); }

  /// Whether an earlier result gave as many pieces as the job wants: they are to be improved alone.
  bool moves_given_pieces_only() const;
  /// Whether other sizes may be tried, and there is nothing more to learn of the present ones: all wanted pieces stand,
  /// or the canvas is covered.
  bool attempt_is_decided() const;
  bool end_at_limit_of_filling();
  /// The region is full: improving begins, where the job wants it.
  void end_filling();
  /// Improves the full region until the trials of the job are used up (improving_phase.h). A run that goes on from a
  /// checkpoint may begin here: why the region is full is found out again.
  void improve();
  /// Begins the next region, if there is one and the loop is not over.
  bool begin_next_region();

  /// Reports the progress, and keeps a checkpoint where one is due.
  void after_step();
  /// Keeps the last checkpoint.
  CollageResult finish();

 private:
  Collage& collage() const { return regions_.current().collage; }
  StopReason why_full() const;
  CheckpointState checkpoint();

  LoopStatistics statistics_;  // first: the set-up begins with it
  const Canvas& canvas_;
  const CollageSettings& settings_;
  ShapeSource& shapes_;
  Observer& observer_;
  CheckpointKeeper* keeper_;
  LoopState state_;
  Regions regions_;  // before the loop's clock, which its set-up is no part of
  LoopEnd end_;
  OwnReplacer own_replacer_;
  Replacer& replacer_;
};

}  // namespace tessera::master
