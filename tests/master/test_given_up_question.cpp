// A question to the matcher may be given up at any point. The state that remains lets the loop continue.
#include <gtest/gtest.h>

#include <limits>

#include "core/base/stop.h"
#include "stopped_collage.h"

namespace tessera::master {
namespace test_given_up_question {

using namespace stopped_collage;

/// A matcher that is interrupted at one of its calls, when a question is posted or an answer is taken.
class InterruptedMatcher : public Matcher {
 public:
  InterruptedMatcher(Matcher& matcher, std::size_t calls) : matcher_(matcher), left_(calls) {}

  ShapeRange shapes() const override { return matcher_.shapes(); }
  void start_field(int width, int height, Vec2 origin) override {
    at_starts_.push_back(left_);
    Matcher& matcher = at_starts_.size() == 1 ? matcher_ : call();  // the first one belongs to no question
    matcher.start_field(width, height, origin);
  }
  void update_field(const std::vector<FieldPatch>& patches) override { call().update_field(patches); }
  void limit(const StanceLimits& limits) override { call().limit(limits); }
  void post_count(const CountRequest& request) override { call().post_count(request); }
  std::vector<DistanceHistogram> take_count() override { return call().take_count(); }
  void post_dock(const DockRequest& request) override {
    if (request.first_drawn) in_wide_gap_pass_.push_back(left_);
    call().post_dock(request);
  }
  DockReply take_dock() override { return call().take_dock(); }
  void post_refine(const std::vector<Docking>& dockings) override { call().post_refine(dockings); }
  std::vector<RefinedDocking> take_refine() override { return call().take_refine(); }
  void post_measure(const std::vector<Docking>& dockings) override { call().post_measure(dockings); }
  std::vector<DockingTerms> take_measure() override { return call().take_measure(); }

  std::size_t calls_left() const { return left_; }
  /// The values of calls_left() at the questions for the first drawn dockings.
  const std::vector<std::size_t>& in_wide_gap_pass() const { return in_wide_gap_pass_; }
  /// The values of calls_left() at the starts of a field.
  const std::vector<std::size_t>& at_starts() const { return at_starts_; }

 private:
  Matcher& call() {
    if (left_ == 0) throw std::logic_error("asked again after an interruption");
    if (--left_ == 0) throw Interrupted{StopReason::signal};
    return matcher_;
  }

  Matcher& matcher_;
  std::size_t left_;
  std::vector<std::size_t> in_wide_gap_pass_, at_starts_;
};

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

/// Runs until the matcher is called for the `calls`-th time, and gives up that question.
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
  std::size_t interrupted_again = 0;
  for (std::size_t i = 0; i < kInterruptions; ++i) {
    KeepLatest keeper;
    std::size_t calls = 1 + (all_calls - 1) * i / (kInterruptions - 1) - i % 3 * (i < kInterruptions - 1 && i > 0);
    const CollageResult interrupted = run_until_call(s, calls, {nullptr, &keeper});
    EXPECT_TRUE(interrupted.unfinished && interrupted.matcher_interrupted) << i;
    EXPECT_EQ(interrupted.statistics.stopped_by, StopReason::signal);
    const CheckpointState first = keeper.latest;
    calls = 2 + i;  // the second interruption comes soon
    if (!run_until_call(s, calls, {&first, &keeper}).unfinished) continue;
    ++interrupted_again;
    const CheckpointState second = keeper.latest;
    SilentObserver silent;
    const CollageResult found = run(s, {4}, silent, {&second, nullptr});
    EXPECT_EQ(found.placements, whole.placements) << i;
    EXPECT_EQ(found.statistics.rounds, whole.statistics.rounds) << i;
    EXPECT_EQ(found.statistics.trials, whole.statistics.trials) << i;
    EXPECT_EQ(found.statistics.trials_kept, whole.statistics.trials_kept) << i;
  }
  EXPECT_GE(interrupted_again, kInterruptions - 2) << "only the last ones may end before they are interrupted again";
}

TEST(GivenUpQuestion, ChangesNothing) { check_given_up_questions(settings()); }

TEST(GivenUpQuestion, ChangesNothingInATrial) { check_given_up_questions(improved()); }

TEST(GivenUpQuestion, ChangesNothingWithOtherSettingsToo) { check_given_up_questions(with_few_uses()); }

/// The last calls belong to the searches that find no more pieces.
TEST(GivenUpQuestion, MayBeAnyOfTheLastSearches) {
  std::size_t all_calls = kNever;
  const CollageResult whole = run_until_call(settings(), all_calls, {});
  bool in_search = false;
  for (std::size_t back = 0; back < 10; ++back) {
    KeepLatest keeper;
    std::size_t calls = all_calls - back;
    EXPECT_TRUE(run_until_call(settings(), calls, {nullptr, &keeper}).unfinished);
    in_search |= keeper.latest.search > 0;
    SilentObserver silent;
    EXPECT_EQ(run(settings(), {}, silent, {&keeper.latest, nullptr}).placements, whole.placements) << back;
  }
  EXPECT_TRUE(in_search);
}

/// The interruption comes between two attempts at sizes (fit = "all"), or where the best attempt is laid again.
TEST(GivenUpQuestion, MayBeTheFirstOfAnotherAttempt) {
  CollageSettings s = settings();
  s.pieces.fit_all = true;
  s.pieces.uses = 1;
  s.pieces.min_scale_px = s.pieces.max_scale_px = 60;
  const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
  const auto interrupted_run = [&](std::size_t calls, const Checkpoints& checkpoints) {
    CompositeMatcher matcher = test::divided_matcher(library(), context, {});
    InterruptedMatcher interrupted(matcher, calls);
    test::VectorShapes shapes(library());
    SilentObserver silent;
    return std::pair(make_collage(canvas(), s, interrupted, shapes, silent, checkpoints), interrupted.at_starts());
  };
  const auto [whole, starts] = interrupted_run(kNever, {});
  ASSERT_GE(starts.size(), 3u);
  for (std::size_t i = 1; i < starts.size(); ++i) {
    KeepLatest keeper;
    EXPECT_TRUE(interrupted_run(kNever - starts[i] + 1, {nullptr, &keeper}).first.unfinished);
    EXPECT_EQ(interrupted_run(kNever, {&keeper.latest, nullptr}).first.placements, whole.placements) << i;
  }
}

/// A library of line art is never filled without searches that look for wide gaps.
TEST(GivenUpQuestion, MayBeOneOfAWideGap) {
  const std::vector<Shape> lines = {test::make_library_shape("spectacles", test::spectacles_outline(0.2f))};
  CollageSettings s = settings();
  s.match.tangent_dockings = 150;
  const MatchingContext context = make_matching_context(s, 1);
  const auto interrupted_run = [&](std::size_t calls, const Checkpoints& checkpoints) {
    CompositeMatcher matcher = test::divided_matcher(lines, context, {});
    InterruptedMatcher interrupted(matcher, calls);
    test::VectorShapes shapes(lines);
    SilentObserver silent;
    return std::pair(make_collage(canvas(), s, interrupted, shapes, silent, checkpoints),
                     interrupted.in_wide_gap_pass());
  };
  const auto [whole, asked] = interrupted_run(kNever, {});
  ASSERT_FALSE(asked.empty());
  for (const std::size_t posted_or_taken : {1, 2}) {
    KeepLatest keeper;
    EXPECT_TRUE(interrupted_run(kNever - asked.front() + posted_or_taken, {nullptr, &keeper}).first.unfinished);
    EXPECT_EQ(keeper.latest.search, 1);
    EXPECT_EQ(interrupted_run(kNever, {&keeper.latest, nullptr}).first.placements, whole.placements);
  }
}

}  // namespace test_given_up_question
}  // namespace tessera::master
