// The order in which a composite matcher asks its parts. MatcherSuite tests that it joins their answers correctly.
#include "core/matching/composite_matcher.h"

#include <gtest/gtest.h>

#include <string>

#include "support/idle_matcher.h"

namespace tessera {
namespace test_composite_matcher {

/// A matcher that counts in a given number of steps. It notes its calls in `calls`: "post 0" is a call of the part with shape 0.
class SteppingMatcher : public test::IdleMatcher {
 public:
  SteppingMatcher(std::uint32_t shape, int steps, std::vector<std::string>& calls)
      : shape_(shape),
        steps_(steps),
        calls_(&calls) {}

  ShapeRange shapes() const override { return {shape_, shape_ + 1}; }
  void post_count(const CountRequest&) override { note("post"); }
  bool step_count() override {
    if (steps_ == 0) return false;
    note("step");
    return --steps_ > 0;
  }
  std::vector<DistanceHistogram> take_count() override {
    EXPECT_EQ(steps_, 0) << "steps are left for the take of part " << shape_;
    note("take");
    return {};
  }

 private:
  void note(const std::string& call) { calls_->push_back(call + " " + std::to_string(shape_)); }

  std::uint32_t shape_;
  int steps_;
  std::vector<std::string>* calls_;
};

using Calls = std::vector<std::string>;

/// A composite of parts that count in the given numbers of steps. Their shapes begin at `first`.
std::unique_ptr<Matcher> stepping_parts(std::uint32_t first, const std::vector<int>& steps, Calls& calls) {
  std::vector<std::unique_ptr<Matcher>> parts;
  for (const int s : steps) {
    parts.push_back(std::make_unique<SteppingMatcher>(first + std::uint32_t(parts.size()), s, calls));
  }
  return std::make_unique<CompositeMatcher>(std::move(parts));
}

TEST(CompositeMatcher, PartsTakeTheirStepsInTurns) {
  Calls calls;
  const auto matcher = stepping_parts(0, {3, 1, 2}, calls);
  matcher->post_count({});
  matcher->take_count();
  EXPECT_EQ(calls, (Calls{"post 0", "post 1", "post 2",  //
                          "step 0", "step 1", "step 2",  //
                          "step 0", "step 2", "step 0",  //
                          "take 0", "take 1", "take 2"}));
}

/// The case of a worker with others below it. The first part is such a worker: it steps by itself and answers slowly.
TEST(CompositeMatcher, DevicesTakeAllTheirStepsBeforeAnythingIsTaken) {
  Calls calls;
  std::vector<std::unique_ptr<Matcher>> parts;
  parts.push_back(std::make_unique<SteppingMatcher>(0, 0, calls));
  parts.push_back(stepping_parts(1, {2, 2}, calls));
  CompositeMatcher matcher(std::move(parts));
  matcher.post_count({});
  matcher.take_count();
  EXPECT_EQ(calls, (Calls{"post 0", "post 1", "post 2",            //
                          "step 1", "step 2", "step 1", "step 2",  //
                          "take 0", "take 1", "take 2"}));
}

TEST(CompositeMatcher, AStepIsOneOfEachPartAndTellsWhetherAnyIsLeft) {
  Calls calls;
  const auto matcher = stepping_parts(0, {2, 1}, calls);
  EXPECT_TRUE(matcher->step_count());
  EXPECT_EQ(calls, (Calls{"step 0", "step 1"}));
  EXPECT_FALSE(matcher->step_count());
  EXPECT_EQ(calls, (Calls{"step 0", "step 1", "step 0"}));
}

/// A part that is only sometimes ready for its next step.
class SlowMatcher : public SteppingMatcher {
 public:
  SlowMatcher(std::uint32_t shape, int steps, int looks, std::vector<std::string>& calls)
      : SteppingMatcher(shape, steps, calls),
        looks_(looks) {}
  bool step_is_ready() override { return ++looked_ % looks_ == 0; }

 private:
  int looks_;
  int looked_ = 0;
};

/// One slow device with a few large steps, and a fast one with several small steps.
TEST(CompositeMatcher, NobodyWaitsForAPartThatIsNotReady) {
  Calls calls;
  std::vector<std::unique_ptr<Matcher>> parts;
  parts.push_back(std::make_unique<SlowMatcher>(0, 2, 4, calls));
  parts.push_back(std::make_unique<SteppingMatcher>(1, 3, calls));
  CompositeMatcher matcher(std::move(parts));
  matcher.post_count({});
  matcher.take_count();
  EXPECT_EQ(calls, (Calls{"post 0", "post 1",            //
                          "step 1", "step 1", "step 1",  //
                          "step 0", "step 0",            //
                          "take 0", "take 1"}));
}

TEST(CompositeMatcher, WhereNoPartIsReadyItWaitsForTheFirst) {
  Calls calls;
  std::vector<std::unique_ptr<Matcher>> parts;
  parts.push_back(std::make_unique<SlowMatcher>(0, 1, 5, calls));
  parts.push_back(std::make_unique<SlowMatcher>(1, 2, 2, calls));
  CompositeMatcher matcher(std::move(parts));
  matcher.post_count({});
  matcher.take_count();
  EXPECT_EQ(calls, (Calls{"post 0", "post 1", "step 1", "step 1", "step 0", "take 0", "take 1"}));
}

class CountingMatcher : public test::IdleMatcher {
 public:
  CountingMatcher(std::uint32_t shape, std::size_t samples) : shape_(shape), samples_(samples) {}
  ShapeRange shapes() const override { return {shape_, shape_ + 1}; }
  void post_count(const CountRequest&) override {}
  std::vector<DistanceHistogram> take_count() override { return std::vector<DistanceHistogram>(samples_); }

 private:
  std::uint32_t shape_;
  std::size_t samples_;
};

TEST(CompositeMatcher, PartsThatCountedDifferentSamplesAreTold) {
  for (const std::size_t of_second : {1u, 3u}) {
    std::vector<std::unique_ptr<Matcher>> parts;
    parts.push_back(std::make_unique<CountingMatcher>(0, 2));
    parts.push_back(std::make_unique<CountingMatcher>(1, of_second));
    CompositeMatcher matcher(std::move(parts));
    EXPECT_THROW(matcher.take_count(), std::logic_error);
  }
}

}  // namespace test_composite_matcher
}  // namespace tessera
