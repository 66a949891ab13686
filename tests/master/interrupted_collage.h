// Whole collages that are interrupted and continued.
#pragma once

#include <gtest/gtest.h>

#include "stopped_collage.h"
#include "whole_collage.h"

namespace tessera::whole_collage {

/// Expects the same pieces on any division of the library, also if the run is interrupted every few steps.
inline void expect_repeatable(const Canvas& canvas, const CollageSettings& s, const master::CollageResult& whole) {
  namespace stopped = master::stopped_collage;
  EXPECT_EQ(run(canvas, s, {5}).placements, whole.placements);
  stopped::KeepLatest keeper;
  master::Checkpoints checkpoints{nullptr, &keeper};
  CheckpointState from;
  for (int part = 0; part < 200; ++part) {
    stopped::StopAfter observer(3);
    const master::CollageResult result = stopped::run(s, {3, 7}, observer, checkpoints, canvas, library());
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
