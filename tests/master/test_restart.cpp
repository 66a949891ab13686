// A loop that is interrupted anywhere and continued from its state places the same pieces as without interruption.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "core/base/stop.h"
#include "stopped_collage.h"

namespace tessera::master {
namespace test_restart {

using namespace stopped_collage;

/// Stops at a given question, also in the middle of a trial.
class StopAtQuestion : public SilentObserver {
 public:
  explicit StopAtQuestion(std::size_t questions) : left_(questions) {}
  std::optional<StopReason> stop_requested() override {
    if (left_ > 0) --left_;
    return left_ == 0 ? std::optional(StopReason::signal) : std::nullopt;
  }

 private:
  std::size_t left_;
};

class CountQuestions : public SilentObserver {
 public:
  std::optional<StopReason> stop_requested() override {
    ++questions;
    return std::nullopt;
  }
  std::size_t questions = 0;
};

/// The number of steps of the whole loop, and its result.
struct Whole {
  explicit Whole(const CollageSettings& s) {
    class Count : public SilentObserver {
     public:
      void progressed(const Progress&) override { ++steps; }
      std::size_t steps = 0;
    } count;
    result = run(s, {}, count);
    steps = count.steps;
  }
  CollageResult result;
  std::size_t steps = 0;
};

/// Runs in parts: each entry of `parts` is a number of steps, with the library divided at `cuts`; then runs to the end.
CollageResult run_in_parts(const CollageSettings& s, const std::vector<std::size_t>& parts,
                           const std::vector<Cuts>& cuts) {
  KeepLatest keeper;
  CheckpointState state;
  const CheckpointState* from = nullptr;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    StopAfter stop(parts[i]);
    const CollageResult result = run(s, cuts[i % cuts.size()], stop, {from, &keeper});
    if (!result.unfinished) return result;
    state = keeper.latest;
    from = &state;
  }
  SilentObserver silent;
  return run(s, cuts[parts.size() % cuts.size()], silent, {from, nullptr});
}

void expect_same(const CollageResult& found, const CollageResult& expected) {
  RC_ASSERT(!found.unfinished);
  RC_ASSERT(found.placements == expected.placements);
  const RunStatistics& a = found.statistics;
  const RunStatistics& b = expected.statistics;
  RC_ASSERT(a.stopped_by == b.stopped_by);
  RC_ASSERT(a.rounds == b.rounds);
  RC_ASSERT(a.trials == b.trials);
  RC_ASSERT(a.trials_kept == b.trials_kept);
  RC_ASSERT(a.target_samples == b.target_samples);
  RC_ASSERT(a.dockings_evaluated == b.dockings_evaluated);
  RC_ASSERT(a.refined == b.refined);
}

void check_random_interruptions(const CollageSettings& s) {
  const Whole whole(s);
  ASSERT_GT(whole.steps, 10u);
  EXPECT_TRUE(rc::check([&] {
    std::vector<std::size_t> parts(*rc::gen::inRange<std::size_t>(1, 4));
    for (std::size_t& steps : parts) steps = *rc::gen::inRange<std::size_t>(0, whole.steps);
    expect_same(run_in_parts(s, parts, {{}, {5}, {1, 2, 9}}), whole.result);
  }));
}

TEST(Restart, AtAnyRoundGivesTheSameCollage) { check_random_interruptions(settings()); }

TEST(Restart, AtAnyTrialGivesTheSameCollage) { check_random_interruptions(improved()); }

TEST(Restart, WithOtherSettingsToo) { check_random_interruptions(with_few_uses()); }

/// The interruptions come within batches, too. There the candidates near the pieces of the batch wait to be measured.
TEST(Restart, WithinABatchGivesTheSameCollage) {
  static const Canvas wide = make_rectangle_canvas(420, 300);
  CollageSettings s = settings();
  s.pieces.max_scale_px = 40;
  SilentObserver silent;
  const CollageResult whole = run(s, {}, silent, {}, wide);
  ASSERT_LT(whole.statistics.rounds + 20, whole.placements.size()) << "the test needs batches of several pieces";
  std::size_t within = 0;
  for (std::size_t steps = 1; steps < whole.placements.size(); steps += 11) {
    KeepLatest keeper;
    StopAfter stop(steps);
    ASSERT_TRUE(run(s, {}, stop, {nullptr, &keeper}, wide).unfinished);
    const CheckpointState state = keeper.latest;
    EXPECT_GT(state.batch_pieces, 0u);
    within += state.batch_pieces > 1;
    const CollageResult found = run(s, {5}, silent, {&state, nullptr}, wide);
    EXPECT_EQ(found.placements, whole.placements) << steps;
    EXPECT_EQ(found.statistics.rounds, whole.statistics.rounds) << steps;
    EXPECT_EQ(found.statistics.target_samples, whole.statistics.target_samples) << steps;
  }
  EXPECT_GT(within, 2u);
}

TEST(Restart, AfterEveryRoundAndTrialGivesTheSameCollage) {
  for (const CollageSettings& s : {improved(), with_few_uses()}) {
    const Whole whole(s);
    const CollageResult found = run_in_parts(s, std::vector<std::size_t>(whole.steps, 1), {{}, {3}});
    EXPECT_EQ(found.placements, whole.result.placements);
    EXPECT_EQ(found.statistics.target_samples, whole.result.statistics.target_samples);
    EXPECT_EQ(found.statistics.trials_kept, whole.result.statistics.trials_kept);
  }
}

/// There are no replacements here, as their questions depend on time (test_replacement_restart). So every run has the same questions.
TEST(Restart, InTheMiddleOfATrialGivesTheSameCollage) {
  CollageSettings s = improved();
  s.pieces.uses = 1000;
  CountQuestions count;
  const CollageResult whole = run(s, {}, count);
  ASSERT_GT(count.questions, 2 * whole.statistics.trials) << "asked within trials, too";
  EXPECT_TRUE(rc::check([&] {
    KeepLatest keeper;
    StopAtQuestion stop(*rc::gen::inRange<std::size_t>(1, count.questions));
    const CollageResult interrupted = run(s, {}, stop, {nullptr, &keeper});
    RC_ASSERT(interrupted.unfinished);
    RC_ASSERT(!interrupted.matcher_interrupted);
    RC_ASSERT(interrupted.statistics.stopped_by == StopReason::signal);
    SilentObserver silent;
    expect_same(run(s, {4}, silent, {&keeper.latest, nullptr}), whole);
  }));
}

/// If hardly any piece fits, a choice tries much of the pool.
TEST(Restart, InTheMiddleOfAChoiceGivesTheSameCollage) {
  for (CollageSettings s : {settings(), with_few_uses()}) {
    s.improve.trials = 0;
    s.pieces.overlap_px = 0;
    CountQuestions count;
    const CollageResult whole = run(s, {}, count);
    ASSERT_GT(count.questions, 5 * whole.statistics.rounds) << "asked within rounds, too";
    EXPECT_TRUE(rc::check([&] {
      KeepLatest keeper;
      StopAtQuestion stop(*rc::gen::inRange<std::size_t>(1, count.questions));
      const CollageResult interrupted = run(s, {}, stop, {nullptr, &keeper});
      RC_ASSERT(interrupted.unfinished);
      RC_ASSERT(!interrupted.matcher_interrupted);
      StopAtQuestion again(*rc::gen::inRange<std::size_t>(1, 40));
      const CheckpointState first = keeper.latest;
      const CollageResult second = run(s, {4}, again, {&first, &keeper});
      SilentObserver silent;
      expect_same(second.unfinished ? run(s, {4}, silent, {&keeper.latest, nullptr}) : second, whole);
    }));
  }
}

/// While candidates that may join a batch are looked for, others are found that have to wait. Looking again must find the same.
TEST(Restart, InTheMiddleOfAChoiceForABatchGivesTheSameCollage) {
  const Canvas wide = make_rectangle_canvas(420, 300);
  CollageSettings s = settings();
  s.pieces.max_scale_px = 40;
  s.pieces.overlap_px = 0;
  CountQuestions count;
  const CollageResult whole = run(s, {}, count, {}, wide);
  ASSERT_LT(whole.statistics.rounds + 20, whole.placements.size()) << "the test needs batches of several pieces";
  for (std::size_t question = 7; question < count.questions; question += count.questions / 10) {
    KeepLatest keeper;
    StopAtQuestion stop(question);
    ASSERT_TRUE(run(s, {}, stop, {nullptr, &keeper}, wide).unfinished);
    const CheckpointState state = keeper.latest;
    SilentObserver silent;
    EXPECT_EQ(run(s, {5}, silent, {&state, nullptr}, wide).placements, whole.placements) << question;
  }
}

TEST(Restart, CheckpointsChangeNothing) {
  class KeepAlways : public KeepLatest {
   public:
    bool due(LoopPhase /*phase*/) override { return true; }
    void keep(const CheckpointState&) override { ++kept; }
    std::size_t kept = 0;
  };
  const Whole whole(improved());
  KeepAlways keeper;
  SilentObserver silent;
  EXPECT_EQ(run(improved(), {}, silent, {nullptr, &keeper}).placements, whole.result.placements);
  EXPECT_EQ(keeper.kept, whole.steps + 1) << "after each step, and at the end";
}

TEST(Restart, OfAFinishedFillingGoesOnImproving) {
  const std::size_t filling = Whole(settings()).steps;
  KeepLatest keeper;
  StopAfter stop(filling + 3);
  CollageSettings s = improved();
  s.improve.relax = false;  // each step is one trial
  EXPECT_EQ(run(s, {}, stop, {nullptr, &keeper}).statistics.stopped_by, StopReason::signal);
  EXPECT_EQ(keeper.latest.loop.phase, LoopPhase::trying);
  EXPECT_EQ(keeper.latest.loop.trials, 3u);
  EXPECT_GT(keeper.latest.loop.improve_s, 0);
  EXPECT_GT(keeper.latest.loop.run_s, keeper.latest.loop.improve_s);
}

TEST(Restart, TimeBeforeTheInterruptionCounts) {
  KeepLatest keeper;
  StopAfter stop(3);
  run(settings(), {}, stop, {nullptr, &keeper});
  CollageSettings s = settings();
  s.stop.seconds = 1000;
  keeper.latest.loop.run_s = 2000;
  SilentObserver silent;
  const CollageResult result = run(s, {}, silent, {&keeper.latest, nullptr});
  EXPECT_EQ(result.placements.size(), 3u);
  EXPECT_EQ(result.statistics.stopped_by, StopReason::seconds);
  EXPECT_FALSE(result.unfinished);
}

/// Earlier counts do not affect how the loop continues.
TEST(Restart, StatisticsDecideNothing) {
  const Whole whole(improved());
  for (const std::size_t steps : {whole.steps / 3, whole.steps - 3}) {
    KeepLatest keeper;
    StopAfter stop(steps);
    ASSERT_TRUE(run(improved(), {}, stop, {nullptr, &keeper}).unfinished);
    for (std::uint64_t* count : {&keeper.latest.statistics.trials, &keeper.latest.statistics.rounds,
                                 &keeper.latest.statistics.target_samples}) {
      *count += 1000;
    }
    keeper.latest.statistics.improve_s = keeper.latest.statistics.total_s = 1e9;
    CollageSettings s = improved();
    s.stop.seconds = 1e6;
    s.improve.seconds = 1e6;
    SilentObserver silent;
    const CollageResult found = run(s, {}, silent, {&keeper.latest, nullptr});
    EXPECT_EQ(found.placements, whole.result.placements);
    EXPECT_EQ(found.statistics.trials, whole.result.statistics.trials);
    EXPECT_LT(found.statistics.total_s, 1e6);
  }
}

}  // namespace test_restart
}  // namespace tessera::master
