// A small collage that is stopped on its way, and the state that it leaves.
#pragma once

#include "core/base/stop.h"
#include "master/collage_loop.h"
#include "support/divided_matcher.h"

namespace tessera::master::stopped_collage {

using Cuts = std::vector<std::uint32_t>;  // the places at which the library is divided among matchers

inline const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(12);
  return shapes;
}

inline const Canvas& canvas() {
  static const Canvas rectangle = make_rectangle_canvas(200, 140);
  return rectangle;
}

inline CollageSettings settings() {
  CollageSettings s;
  s.seed = 5;
  s.pieces.min_scale_px = 18;
  s.pieces.max_scale_px = 70;
  s.match.tangent_dockings = 60;
  return s;
}

inline CollageSettings improved() {
  CollageSettings s = settings();
  s.improve.trials = 12;
  return s;
}

inline CollageSettings with_few_uses() {
  CollageSettings s = improved();
  s.pieces.uses = 2;
  s.pieces.padding_px = 1.5f;
  s.objective.kind = Objective::paper;
  return s;
}

/// Stops after the given number of rounds and trials.
class StopAfter : public SilentObserver {
 public:
  explicit StopAfter(std::size_t steps) : left_(steps) {}
  void progressed(const Progress&) override { --left_; }
  std::optional<StopReason> stop_requested() override {
    return left_ == 0 ? std::optional(StopReason::signal) : std::nullopt;
  }

 private:
  std::size_t left_;
};

class KeepLatest : public CheckpointKeeper {
 public:
  bool due(LoopPhase /*phase*/) override { return false; }
  void keep(const CheckpointState& state) override { latest = state; }
  CheckpointState latest;
};

inline CollageResult run(const CollageSettings& s, const Cuts& cuts, Observer& observer,
                         const Checkpoints& checkpoints = {}, const Canvas& canvas = stopped_collage::canvas(),
                         const std::vector<Shape>& library = stopped_collage::library()) {
  const MatchingContext context = make_matching_context(s, std::uint32_t(library.size()));
  CompositeMatcher matcher = test::divided_matcher(library, context, cuts);
  test::VectorShapes shapes(library);
  return make_collage(canvas, s, matcher, shapes, observer, checkpoints);
}

}  // namespace tessera::master::stopped_collage
