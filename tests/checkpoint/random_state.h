// A state of the collage's loop with random values in every field.
#pragma once

#include <cmath>
#include <random>

#include "core/collage/checkpoint_state.h"
#include "core/settings/tuning.h"

namespace tessera::test {

class RandomState {
 public:
  explicit RandomState(std::uint32_t seed) : random_(seed) {}

  CheckpointState make() {
    CheckpointState state;
    const bool improving = below(2) == 1;
    state.search = int(below(4));
    state.searched = below(4);
    for (std::uint32_t i = below(20); i > 0; --i) {
      state.placements.push_back({ShapeId{below(100)}, pose(), number(), number()});
    }
    for (std::uint32_t i = below(20); i > 0; --i) {
      state.loop.moving.push_back({ShapeId{below(100)}, pose(), number(), number()});
    }
    if (improving) state.loop.phase = state.loop.moving.empty() ? LoopPhase::trying : LoopPhase::replacing;
    state.loop.replaced = below(1000);
    for (const SampleId id : ascending()) state.pool.push_back({id, below(2) == 1, candidates()});
    state.stale = ascending();
    for (const SampleId id : ascending()) state.matches.push_back({id, below(9), below(4)});
    for (const SampleId id : ascending()) state.matched.push_back(pad(id));
    fill(state.statistics);
    state.loop.trials = state.statistics.trials;
    state.loop.improve_s = state.statistics.improve_s;
    state.loop.run_s = state.statistics.total_s;
    state.rebuilt_digest = std::uint64_t(random_()) << 32 | random_();
    state.loop.region = below(3);
    state.given = below(3);
    state.sizes = {below(3), 0.25f * float(1 + below(4)), 0.25f * float(below(4)), 0.25f * float(below(4)),
                   below(2) == 1};
    state.best = {0.25f * float(below(4)), below(9), {}};
    for (std::uint32_t i = below(20); i > 0; --i) {
      state.best.placements.push_back({ShapeId{below(100)}, pose(), number(), number()});
    }
    state.batch_pieces = below(100);
    state.batch_worth = 0.01f * float(below(100));
    for (std::uint32_t i = below(20); i > 0; --i) state.batch_taken.push_back(std::uint8_t(below(2)));
    return state;
  }

 private:
  std::uint32_t below(std::uint32_t end) { return std::uint32_t(random_() % end); }
  float number() { return std::uniform_real_distribution<float>(-500, 500)(random_); }
  Similarity pose() { return {number(), number(), number(), number()}; }

  std::vector<SampleId> ascending() {
    std::vector<SampleId> ids(below(30));
    std::uint32_t edge = 0;
    for (SampleId& id : ids) id = SampleId{edge += 1 + below(100)};
    return ids;
  }

  std::vector<Candidate> candidates() {
    std::vector<Candidate> list(below(kPoolPerSample + 1));
    for (Candidate& c : list) {
      c = {ShapeId{below(100)},
           below(5000),
           below(50),
           pose(),
           {number(), number(), number(), number(), number()},
           number(),
           below(2) == 1,
           {int(below(900)) - 100, int(below(900)), int(below(900)), int(below(900))},
           number(),
           number()};
    }
    return list;
  }

  MatchedPad pad(SampleId id) {
    MatchedPad pad{id, {}, {}, number()};
    for (float& length : pad.left) length = number();
    for (float& length : pad.right) length = number();
    return pad;
  }

  void fill(RunStatistics& s) {
    for (std::uint64_t* count : {&s.shapes, &s.rounds, &s.docking_choices, &s.dockings_evaluated, &s.refined,
                                 &s.target_samples, &s.trials, &s.trials_kept}) {
      *count = below(1'000'000);
    }
    for (double* measure :
         {&s.pads_per_shape, &s.prune_s, &s.dock_s, &s.objective_s, &s.merge_s, &s.improve_s, &s.total_s}) {
      *measure = std::abs(double(number()));
    }
  }

  std::mt19937 random_;
};

}  // namespace tessera::test
