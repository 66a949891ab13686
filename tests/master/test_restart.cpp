// A loop that is interrupted anywhere and goes on from its state places what it would have placed without.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>

#include "core/base/error.h"
#include "core/base/interrupted.h"
#include "master/collage_loop.h"
#include "support/divided_matcher.h"

namespace tessera::master {
namespace {

using Cuts = std::vector<std::uint32_t>;  // where the library is divided among matchers

const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(12);
  return shapes;
}

const Canvas& canvas() {
  static const Canvas rectangle = make_rectangle_canvas(200, 140);
  return rectangle;
}

CollageSettings settings() {
  CollageSettings s;
  s.seed = 5;
  s.pieces.min_scale_px = 18;
  s.pieces.max_scale_px = 70;
  s.match.tangent_dockings = 60;
  return s;
}

CollageSettings improved() {
  CollageSettings s = settings();
  s.improve.trials = 12;
  return s;
}

CollageSettings with_few_uses() {
  CollageSettings s = improved();
  s.pieces.uses = 2;
  s.pieces.padding_px = 1.5f;
  s.objective.kind = Objective::paper;
  return s;
}

/// Stops after so many rounds and trials.
class StopAfter : public SilentObserver {
 public:
  explicit StopAfter(std::size_t steps) : left_(steps) {}
  void progressed(const Progress&) override { --left_; }
  const char* stop_requested() override { return left_ == 0 ? "signal" : nullptr; }

 private:
  std::size_t left_;
};

/// Stops when it was asked so often: in the middle of a trial, too.
class StopAtQuestion : public SilentObserver {
 public:
  explicit StopAtQuestion(std::size_t questions) : left_(questions) {}
  const char* stop_requested() override {
    if (left_ > 0) --left_;
    return left_ == 0 ? "signal" : nullptr;
  }

 private:
  std::size_t left_;
};

class KeepLatest : public CheckpointKeeper {
 public:
  bool due() override { return false; }
  void keep(const CheckpointState& state) override { latest = state; }
  CheckpointState latest;
};

/// Is told to stop at one of its questions: where it would be posted, or where its answer would be taken.
class InterruptedMatcher : public Matcher {
 public:
  InterruptedMatcher(Matcher& matcher, std::size_t calls) : matcher_(matcher), left_(calls) {}

  ShapeRange shapes() const override { return matcher_.shapes(); }
  void start_field(int width, int height, Vec2 origin) override { matcher_.start_field(width, height, origin); }
  void update_field(const FieldPatch& patch) override { call().update_field(patch); }
  void post_count(const CountRequest& request) override { call().post_count(request); }
  std::vector<DistanceHistogram> take_count() override { return call().take_count(); }
  void post_dock(const DockRequest& request) override { call().post_dock(request); }
  DockReply take_dock() override { return call().take_dock(); }
  void post_refine(const std::vector<Docking>& dockings) override { call().post_refine(dockings); }
  std::vector<RefinedDocking> take_refine() override { return call().take_refine(); }
  void post_measure(const std::vector<Docking>& dockings) override { call().post_measure(dockings); }
  std::vector<DockingTerms> take_measure() override { return call().take_measure(); }

  std::size_t calls_left() const { return left_; }

 private:
  Matcher& call() {
    if (left_ == 0) throw std::logic_error("asked again after an interruption");
    if (--left_ == 0) throw Interrupted{"signal"};
    return matcher_;
  }

  Matcher& matcher_;
  std::size_t left_;
};

CollageResult run(const CollageSettings& s, const Cuts& cuts, Observer& observer, const Checkpoints& checkpoints = {}) {
  const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
  CompositeMatcher matcher = test::divided_matcher(library(), context, cuts);
  test::VectorShapes shapes(library());
  return make_collage(canvas(), s, matcher, shapes, observer, checkpoints);
}

/// Steps of the whole loop, and what it gives.
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

/// Runs in pieces: each entry of `parts` is so many steps, with the library divided as `cuts` says; then to the end.
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

TEST(Restart, AfterEveryRoundAndTrialGivesTheSameCollage) {
  for (const CollageSettings& s : {improved(), with_few_uses()}) {
    const Whole whole(s);
    const CollageResult found = run_in_parts(s, std::vector<std::size_t>(whole.steps, 1), {{}, {3}});
    EXPECT_EQ(found.placements, whole.result.placements);
    EXPECT_EQ(found.statistics.target_samples, whole.result.statistics.target_samples);
    EXPECT_EQ(found.statistics.trials_kept, whole.result.statistics.trials_kept);
  }
}

TEST(Restart, InTheMiddleOfATrialGivesTheSameCollage) {
  class CountQuestions : public SilentObserver {
   public:
    const char* stop_requested() override {
      ++questions;
      return nullptr;
    }
    std::size_t questions = 0;
  } count;
  const CollageResult whole = run(improved(), {}, count);
  ASSERT_GT(count.questions, 2 * whole.statistics.trials) << "asked within trials, too";
  EXPECT_TRUE(rc::check([&] {
    KeepLatest keeper;
    StopAtQuestion stop(*rc::gen::inRange<std::size_t>(1, count.questions));
    const CollageResult interrupted = run(improved(), {}, stop, {nullptr, &keeper});
    RC_ASSERT(interrupted.unfinished);
    RC_ASSERT(interrupted.statistics.stopped_by == "signal");
    SilentObserver silent;
    expect_same(run(improved(), {4}, silent, {&keeper.latest, nullptr}), whole);
  }));
}

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

/// Gives the question up with which the matcher was called for the `calls`-th time.
CollageResult run_until_call(const CollageSettings& s, std::size_t& calls, const Checkpoints& checkpoints) {
  const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
  CompositeMatcher matcher = test::divided_matcher(library(), context, {});
  InterruptedMatcher interrupted(matcher, calls);
  test::VectorShapes shapes(library());
  SilentObserver silent;
  const CollageResult result = make_collage(canvas(), s, interrupted, shapes, silent, checkpoints);
  calls -= interrupted.calls_left();
  return result;
}

void check_given_up_questions(const CollageSettings& s) {
  std::size_t all_calls = kNever;
  const CollageResult whole = run_until_call(s, all_calls, {});
  ASSERT_GT(all_calls, 50u);
  constexpr std::size_t kInterruptions = 10;
  for (std::size_t i = 0; i < kInterruptions; ++i) {
    KeepLatest keeper;
    std::size_t calls = 1 + (all_calls - 1) * i / (kInterruptions - 1) - i % 3 * (i < kInterruptions - 1 && i > 0);
    const CollageResult interrupted = run_until_call(s, calls, {nullptr, &keeper});
    EXPECT_TRUE(interrupted.unfinished && interrupted.gave_up_question) << i;
    EXPECT_EQ(interrupted.statistics.stopped_by, "signal");
    const CheckpointState first = keeper.latest;
    calls = 2 + i;  // and soon once more
    if (!run_until_call(s, calls, {&first, &keeper}).unfinished) continue;
    const CheckpointState second = keeper.latest;
    SilentObserver silent;
    const CollageResult found = run(s, {4}, silent, {&second, nullptr});
    EXPECT_EQ(found.placements, whole.placements) << i;
    EXPECT_EQ(found.statistics.rounds, whole.statistics.rounds) << i;
    EXPECT_EQ(found.statistics.trials, whole.statistics.trials) << i;
    EXPECT_EQ(found.statistics.trials_kept, whole.statistics.trials_kept) << i;
  }
}

TEST(Restart, AQuestionGivenUpChangesNothing) { check_given_up_questions(settings()); }

TEST(Restart, AQuestionGivenUpInATrialChangesNothing) { check_given_up_questions(improved()); }

TEST(Restart, AQuestionGivenUpChangesNothingWithOtherSettingsToo) { check_given_up_questions(with_few_uses()); }

/// The last calls are those of the passes in which nothing is found any more.
TEST(Restart, EveryQuestionOfTheLastPassesMayBeGivenUp) {
  std::size_t all_calls = kNever;
  const CollageResult whole = run_until_call(settings(), all_calls, {});
  bool in_empty_pass = false;
  for (std::size_t back = 0; back < 10; ++back) {
    KeepLatest keeper;
    std::size_t calls = all_calls - back;
    EXPECT_TRUE(run_until_call(settings(), calls, {nullptr, &keeper}).unfinished);
    in_empty_pass |= keeper.latest.empty_passes > 0;
    SilentObserver silent;
    EXPECT_EQ(run(settings(), {}, silent, {&keeper.latest, nullptr}).placements, whole.placements) << back;
  }
  EXPECT_TRUE(in_empty_pass);
}

TEST(Restart, CheckpointsChangeNothing) {
  class KeepAlways : public KeepLatest {
   public:
    bool due() override { return true; }
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
  EXPECT_EQ(run(improved(), {}, stop, {nullptr, &keeper}).statistics.stopped_by, "signal");
  EXPECT_TRUE(keeper.latest.improving);
  EXPECT_EQ(keeper.latest.statistics.trials, 3u);
  EXPECT_GT(keeper.latest.statistics.improve_s, 0);
  EXPECT_GT(keeper.latest.statistics.total_s, keeper.latest.statistics.improve_s);
}

TEST(Restart, TimeBeforeTheInterruptionCounts) {
  KeepLatest keeper;
  StopAfter stop(3);
  run(settings(), {}, stop, {nullptr, &keeper});
  CollageSettings s = settings();
  s.stop.seconds = 1000;
  keeper.latest.statistics.total_s = 2000;
  SilentObserver silent;
  const CollageResult result = run(s, {}, silent, {&keeper.latest, nullptr});
  EXPECT_EQ(result.placements.size(), 3u);
  EXPECT_EQ(result.statistics.stopped_by, "seconds");
  EXPECT_FALSE(result.unfinished);
}

/// A state after some rounds, for damage.
class ForeignState : public testing::Test {
 protected:
  void SetUp() override {
    KeepLatest keeper;
    StopAfter stop(4);
    run(settings(), {}, stop, {nullptr, &keeper});
    state_ = keeper.latest;
    state_.name = "checkpoint.h5";
  }

  std::string complaint() const {
    SilentObserver silent;
    try {
      run(settings(), {}, silent, {&state_, nullptr});
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  void expect_complaint(const std::string& what) const {
    EXPECT_EQ(complaint(), "checkpoint.h5: not a checkpoint of this canvas and library: " + what +
                               "; --restart removes it and starts again");
  }

  CheckpointState state_;
};

TEST_F(ForeignState, IsFineBeforeTheChange) { EXPECT_EQ(complaint(), "none"); }

TEST_F(ForeignState, PiecesInAnotherPlace) {
  state_.placements[1].canvas_from_shape.tx += 0.25f;
  state_.pool.clear();
  state_.stale.clear();
  state_.matched.clear();
  expect_complaint("its pieces do not give the free region that it was written for");
}

TEST_F(ForeignState, ShapesThatDoNotExist) {
  state_.placements[0].shape = ShapeId{12};
  expect_complaint("shape 12 of 12");
}

TEST_F(ForeignState, CandidatesThatDoNotExist) {
  for (PooledSample& sample : state_.pool) {
    for (Candidate& c : sample.candidates) c.shape = ShapeId{4'000'000'000u};
  }
  expect_complaint("shape 4000000000 of 12");
}

TEST_F(ForeignState, AbsurdPoses) {
  for (const float absurd : {1e30f, -1e9f, std::numeric_limits<float>::quiet_NaN()}) {
    state_.placements[0].canvas_from_shape.ty = absurd;
    expect_complaint("a piece out of all proportion");
  }
  for (const float scale_px : {0.f, 1.f, 1e6f}) {
    state_.placements[0].canvas_from_shape = {scale_px, 0, 10, 10};
    expect_complaint("a piece out of all proportion");
  }
}

TEST_F(ForeignState, AbsurdWindows) {
  for (const int absurd : {std::numeric_limits<int>::min(), -1'000'000, 5000}) {
    for (PooledSample& sample : state_.pool) {
      for (Candidate& c : sample.candidates) c.window.x0 = absurd;
    }
    expect_complaint("a candidate out of all proportion");
  }
}

TEST_F(ForeignState, AbsurdShapeSizes) {
  for (const float size : {0.f, -5.f, 1e30f, std::numeric_limits<float>::quiet_NaN()}) {
    for (float Candidate::*member : {&Candidate::perimeter, &Candidate::radius}) {
      const CheckpointState whole = state_;
      for (PooledSample& sample : state_.pool) {
        for (Candidate& c : sample.candidates) c.*member = size;
      }
      expect_complaint("a candidate out of all proportion");
      state_ = whole;
    }
  }
}

TEST_F(ForeignState, MorePassesThanThereCanBe) {
  state_.empty_passes = 3;
  EXPECT_EQ(complaint(), "checkpoint.h5: not a checkpoint of this job: 3 passes without a piece; --restart removes it and "
                         "starts again");
}

TEST_F(ForeignState, TargetSamplesThatDoNotExist) {
  state_.stale.push_back(SampleId{4'000'000'000u});
  expect_complaint("there is no target sample 4000000000");
  state_.stale.clear();
  state_.matched.push_back({});
  expect_complaint("there is no target sample 0");
}

}  // namespace
}  // namespace tessera::master
