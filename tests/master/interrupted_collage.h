// Whole collages that are interrupted and go on.
#pragma once

#include <gtest/gtest.h>

#include "whole_collage.h"

namespace tessera::whole_collage {

using master::Checkpoints;
using master::CheckpointKeeper;
using master::CollageResult;
using master::Observer;
using master::Progress;
using master::SilentObserver;

class StopAfter : public SilentObserver {
 public:
  explicit StopAfter(std::size_t steps) : left_(steps) {}
  void progressed(const Progress&) override { --left_; }
  const char* stop_requested() override { return left_ == 0 ? "signal" : nullptr; }

 private:
  std::size_t left_;
};

class KeepLatest : public CheckpointKeeper {
 public:
  bool due() override { return false; }
  void keep(const CheckpointState& state) override { latest = state; }
  CheckpointState latest;
};

inline CollageResult run_from(const Canvas& canvas, const CollageSettings& s, Observer& observer, const Checkpoints& checkpoints) {
  const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
  CompositeMatcher matcher = test::divided_matcher(library(), context, {3, 7});
  test::VectorShapes shapes(library());
  return master::make_collage(canvas, s, matcher, shapes, observer, checkpoints);
}

/// The same pieces on any division of the library, and when the run is interrupted every few steps.
inline void expect_repeatable(const Canvas& canvas, const CollageSettings& s, const CollageResult& whole) {
  EXPECT_EQ(run(canvas, s, {5}).placements, whole.placements);
  KeepLatest keeper;
  Checkpoints checkpoints{nullptr, &keeper};
  CheckpointState from;
  for (int part = 0; part < 200; ++part) {
    StopAfter observer(3);
    const CollageResult result = run_from(canvas, s, observer, checkpoints);
    if (!result.unfinished) {
      EXPECT_GT(part, 2);
      EXPECT_EQ(result.placements, whole.placements);
      return;
    }
    from = keeper.latest;
    checkpoints.from = &from;
  }
  FAIL() << "does not end";
}

}  // namespace tessera::whole_collage
