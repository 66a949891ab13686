// A loop that is interrupted during replacement trials continues from its state. A foreign state is refused.
#include <gtest/gtest.h>

#include <limits>

#include "core/base/stop.h"
#include "foreign_state.h"
#include "replacement_phase.h"

namespace tessera::master {
namespace test_replacement_restart {

using namespace replacement_phase;

class CountQuestions : public SilentObserver {
 public:
  std::optional<StopReason> stop_requested() override {
    return ++questions >= stop_at ? std::optional(StopReason::signal) : std::nullopt;
  }
  std::size_t questions = 0;
  std::size_t stop_at = std::numeric_limits<std::size_t>::max();  // stops at this question and all later ones
};

/// A whole run, with the observer's questions at which its phase begins, and at which its pieces settle.
class InterruptedPhase : public testing::Test {
 protected:
  void SetUp() override {
    CountQuestions observer;
    test::AskedReplacer replacer([&](const ReplacementWindow& window) {
      if (begins_ == 0) begins_ = observer.questions;
      const ReplacementOutcome outcome = try_(window);
      settles_ = observer.questions;
      return outcome;
    });
    whole_ = run(small_canvas(), settings_, &replacer, observer);
    ASSERT_GT(replacer.batches.size(), 1u);
    CountQuestions looking;
    test::AskedReplacer looks(looking_trials(looking));
    ASSERT_EQ(run(small_canvas(), settings_, &looks, looking).placements, whole_.placements);
    questions_ = looking.questions;
  }

  /// Trials that ask the observer before each trial, so that every run asks the same questions. The questions of an OwnReplacer depend on
  /// time.
  static test::AskedReplacer::Answer looking_trials(CountQuestions& observer) {
    return test::real_trials(library(), [&observer] {
      if (const auto reason = observer.stop_requested()) throw Interrupted{*reason};
    });
  }

  void expect_same(const CollageResult& found, const std::string& where) const {
    EXPECT_FALSE(found.unfinished) << where;
    EXPECT_EQ(found.placements, whole_.placements) << where;
    EXPECT_EQ(found.statistics.trials, whole_.statistics.trials) << where;
    EXPECT_EQ(found.statistics.trials_kept, whole_.statistics.trials_kept) << where;
    EXPECT_EQ(found.statistics.stopped_by, whole_.statistics.stopped_by) << where;
  }

  CollageResult go_on(const CheckpointState& from) const {
    return run(small_canvas(), settings_, nullptr, *std::make_unique<SilentObserver>(), {&from, nullptr});
  }

  const CollageSettings settings_ = settings(5, 30, 60);
  const test::AskedReplacer::Answer try_ = test::real_trials(library());
  CollageResult whole_;
  std::size_t begins_ = 0;
  std::size_t settles_ = 0;
  std::size_t questions_ = 0;  // with looking_trials()
};

/// The run is stopped at any question from the beginning of the phase on.
TEST_F(InterruptedPhase, GoesOnFromAnyQuestion) {
  int in_phase = 0;
  int settling = 0;
  constexpr std::size_t kInterruptions = 12;
  for (std::size_t k = 0; k < kInterruptions; ++k) {
    CountQuestions observer;
    observer.stop_at = begins_ + (questions_ - begins_) * k / kInterruptions;
    KeepLatest keeper;
    test::AskedReplacer looks(looking_trials(observer));
    const CollageResult stopped = run(small_canvas(), settings_, &looks, observer, {nullptr, &keeper});
    ASSERT_TRUE(stopped.unfinished) << k;
    EXPECT_EQ(stopped.statistics.stopped_by, StopReason::signal);
    const CheckpointState state = keeper.latest;
    in_phase += !state.loop.moving.empty() && state.loop.replaced < 20;
    settling += !state.loop.moving.empty() && state.loop.replaced == 20;
    // The pieces that an interrupted run gives out are valid.
    EXPECT_LT(quality(small_canvas(), stopped).overlap, 0.01) << k;
    expect_same(go_on(state), "stopped at " + std::to_string(observer.stop_at));
  }
  EXPECT_GT(in_phase, 0);
  EXPECT_GT(settling, 0);
}

/// The loop's own replacer checks for a stop during its work, and gives up no question then.
TEST_F(InterruptedPhase, OfTheLoopsOwnReplacerGoesOn) {
  CountQuestions observer;
  observer.stop_at = begins_ + 1;
  KeepLatest keeper;
  const CollageResult stopped = run(small_canvas(), settings_, nullptr, observer, {nullptr, &keeper});
  EXPECT_TRUE(stopped.unfinished);
  EXPECT_FALSE(stopped.matcher_interrupted);
  EXPECT_FALSE(keeper.latest.loop.moving.empty());
  expect_same(go_on(keeper.latest), "in the first batch");
}

TEST_F(InterruptedPhase, AReplacerThatGivesUpLeavesTheStateBeforeTheBatch) {
  for (std::size_t batch = 1; batch <= 2; ++batch) {
    KeepLatest keeper;
    std::size_t windows = 0;
    test::AskedReplacer giving_up([&](const ReplacementWindow& window) {
      if (++windows == batch) throw Interrupted{StopReason::lost_rank};
      return try_(window);
    });
    SilentObserver silent;
    const CollageResult stopped = run(small_canvas(), settings_, &giving_up, silent, {nullptr, &keeper});
    EXPECT_TRUE(stopped.unfinished);
    EXPECT_TRUE(stopped.matcher_interrupted);
    EXPECT_EQ(stopped.statistics.stopped_by, StopReason::lost_rank);
    EXPECT_EQ(giving_up.batches.size(), batch) << "not asked again";
    EXPECT_FALSE(keeper.latest.loop.moving.empty());
    EXPECT_EQ(keeper.latest.loop.replaced == 0, batch == 1);
    expect_same(go_on(keeper.latest), "batch " + std::to_string(batch));
  }
}

/// Each step runs from the state that the last one left.
TEST_F(InterruptedPhase, GoesOnAfterEveryStep) {
  KeepLatest keeper;
  CheckpointState state;
  const CheckpointState* from = nullptr;
  int moving = 0;
  for (int step = 0; step < 200; ++step) {
    stopped_collage::StopAfter stop(1);
    const CollageResult result = run(small_canvas(), settings_, nullptr, stop, {from, &keeper});
    if (!result.unfinished) {
      expect_same(result, "in steps");
      EXPECT_GE(moving, 2);
      return;
    }
    state = keeper.latest;
    moving += !state.loop.moving.empty();
    from = &state;
  }
  FAIL() << "does not end";
}

/// If hardly any piece may move, the batches are small, and the trials are used up before the phase is over.
TEST(InterruptedSettling, IsTakenUpAgainAlsoWhereTrialsAreUsedUp) {
  const CollageSettings free = settings(6, 30, 60);
  CollageSettings s = free;
  s.improve.trials = 0;
  const CollageResult filled = run(small_canvas(), s, nullptr);
  s = free;
  for (const Placement& p : filled.placements) s.wishes.given.push_back({p.shape, p.canvas_from_shape, true});
  s.wishes.given.back().locked = false;
  CountQuestions observer;
  const auto try_it = test::real_trials(library());
  test::AskedReplacer trying(try_it);
  std::size_t settles = 0;
  test::AskedReplacer counting([&](const ReplacementWindow& window) {
    settles = observer.questions;
    return try_it(window);
  });
  const CollageResult whole = run(small_canvas(), s, &counting, observer);
  EXPECT_EQ(whole.statistics.trials, 6u);
  std::uint64_t done = 0;
  for (const auto& windows : counting.batches) done += trials_of(windows);
  ASSERT_LT(done, 40u) << "a part of the phase";
  ASSERT_GT(observer.questions, settles + 10);
  CountQuestions stopping;
  stopping.stop_at = settles + 8;
  KeepLatest keeper;
  const CollageResult stopped = run(small_canvas(), s, &trying, stopping, {nullptr, &keeper});
  EXPECT_TRUE(stopped.unfinished) << "interrupted while pieces settled";
  EXPECT_FALSE(keeper.latest.loop.moving.empty());
  SilentObserver silent;
  const CollageResult found = run(small_canvas(), s, nullptr, silent, {&keeper.latest, nullptr});
  EXPECT_EQ(found.placements, whole.placements);
  EXPECT_EQ(found.statistics.trials_kept, whole.statistics.trials_kept);
}

/// A state in the middle of the phase, which the tests damage.
class ForeignPhase : public test::ForeignStateTest {
 protected:
  void SetUp() override {
    settings_.wishes.given = {{ShapeId{2}, {40, 0, 80, 60}, true}};
    KeepLatest keeper;
    std::size_t windows = 0;
    test::AskedReplacer giving_up([&](const ReplacementWindow& window) {
      if (++windows == 2) throw Interrupted{StopReason::signal};
      return test::as_it_was(window);
    });
    SilentObserver silent;
    run(small_canvas(), settings_, &giving_up, silent, {nullptr, &keeper});
    state_ = keeper.latest;
    state_.name = "checkpoint.h5";
    ASSERT_GT(state_.loop.moving.size(), 2u);
    ASSERT_EQ(state_.loop.phase, LoopPhase::replacing);
  }

  void go_on() const override {
    SilentObserver silent;
    test::AskedReplacer idle;
    run(small_canvas(), settings_, &idle, silent, {&state_, nullptr});
  }

  CollageSettings settings_ = settings(5, 30, 60);
};

TEST_F(ForeignPhase, IsFineBeforeTheChange) { EXPECT_EQ(complaint(), "none"); }

TEST_F(ForeignPhase, MovingPiecesOfUnknownShapes) {
  state_.loop.moving.back().shape = ShapeId{12};
  expect_complaint("shape 12 of 12");
}

TEST_F(ForeignPhase, AbsurdPoses) {
  for (const float absurd : {1e30f, -1e9f, std::numeric_limits<float>::quiet_NaN()}) {
    const CheckpointState whole = state_;
    state_.loop.moving.back().canvas_from_shape.tx = absurd;
    expect_complaint("a piece with an impossible size or place");
    state_ = whole;
    state_.loop.moving.back().canvas_from_shape.a = absurd;
    expect_complaint("a piece with an impossible size or place");
    state_ = whole;
  }
  state_.loop.moving.back().canvas_from_shape.a = 1e-5f;
  state_.loop.moving.back().canvas_from_shape.b = 0;
  expect_complaint("a piece with an impossible size or place");
}

TEST_F(ForeignPhase, GivenOnesThatMoved) {
  state_.loop.moving.front().canvas_from_shape.tx += 1;
  expect_complaint("its replacement phase moves pieces that must stay");
  state_.loop.moving.clear();
  state_.loop.moving.push_back(state_.placements.back());
  expect_complaint("its replacement phase moves pieces that must stay");
}

TEST_F(ForeignPhase, PiecesThatMoveWhileTheCanvasIsFilled) {
  state_.loop.phase = LoopPhase::filling;
  expect_complaint("its replacement phase moves pieces that must stay");
}

TEST_F(ForeignPhase, MorePiecesThanHaveRoom) {
  state_.loop.moving.insert(state_.loop.moving.end(), 1000, state_.loop.moving.back());
  expect_complaint("its replacement phase has far more pieces than fit");
}

/// The number is larger than possible, so the phase is over.
TEST_F(ForeignPhase, AnyNumberOfTrialsIsFine) {
  state_.loop.replaced = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(complaint(), "none");
}

}  // namespace test_replacement_restart
}  // namespace tessera::master
