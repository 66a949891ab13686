// The estimate of a run's time from its progress so far.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "run/progress/time_estimate.h"

namespace tessera::cli {
namespace test_time_estimate {

TEST(ExpectedTimeShare, the_nearest_stop_gives_the_share) {
  const master::Progress progress{.pieces = 50, .coverage = 0.3, .seconds = 6, .open_samples = 0};
  EXPECT_DOUBLE_EQ(expected_time_share(progress, {.pieces = 100, .coverage = 1, .seconds = 0}), 0.5);
  EXPECT_DOUBLE_EQ(expected_time_share(progress, {.pieces = 100, .coverage = 1, .seconds = 8}), 0.75);
  EXPECT_DOUBLE_EQ(expected_time_share(progress, {.pieces = 50, .coverage = 1, .seconds = 0}), 0.99);
  EXPECT_NEAR(expected_time_share(progress, {.pieces = 0, .coverage = 0.6f, .seconds = 0}), 0.5, 1e-6);
  EXPECT_NEAR(expected_time_share(progress, {.pieces = 0, .coverage = 1, .seconds = 0}), 0.67 / 3, 1e-6);
}

RC_GTEST_PROP(ExpectedTimeShare, the_share_grows_and_stays_below_one, ()) {
  const auto percent = [] { return double(*rc::gen::inRange(0, 101)) / 100; };
  const double low = percent();
  const double high = low + (1 - low) * percent();
  const StopSettings stop{
      .pieces = *rc::gen::inRange(0, 50), .coverage = float(0.01 + 0.99 * percent()), .seconds = 10 * percent()};
  const auto at = [&](double share) {
    return expected_time_share(
        {.pieces = std::size_t(100 * share), .coverage = share, .seconds = 9 * share, .open_samples = 0}, stop);
  };
  RC_ASSERT(0 <= at(low));
  RC_ASSERT(at(low) <= at(high));
  RC_ASSERT(at(high) <= 1);
}

const ImproveSettings kNoTrials;

/// A canvas that is half filled after 10 s.
master::Progress half_filled() { return {.pieces = 100, .coverage = 0.3, .seconds = 10}; }

TEST(TimeEstimate, GoesByThePaceOfFilling) {
  TimeEstimate estimate({.pieces = 0, .coverage = 0.6f, .seconds = 0}, kNoTrials);
  EXPECT_EQ(estimate.left_s({}), std::nullopt);
  EXPECT_EQ(estimate.left_s({.pieces = 1, .coverage = 0.002, .seconds = 1}), std::nullopt) << "too early to tell";
  EXPECT_NEAR(estimate.left_s(half_filled()).value(), 10, 1e-3);
}

/// Without the trials the estimate would stay at "0:00 left".
TEST(TimeEstimate, TrialsThatAreToComeTakeTimeToo) {
  TimeEstimate estimate({}, {.trials = 2000, .seconds = 0});
  estimate.left_s({});
  const double filling_s = 10 / (0.67 / 3) - 10;  // the_nearest_stop_gives_the_share
  EXPECT_NEAR(estimate.left_s(half_filled()).value(), filling_s + 2000 * 2 * 0.1, 1e-3);
}

TEST(TimeEstimate, TrialsThatALimitOfTheFillingLeavesOutTakeNone) {
  const ImproveSettings good{.trials = 2000, .seconds = 0};
  for (const StopSettings& stop : {StopSettings{.coverage = 0.6f}, StopSettings{.pieces = 200}}) {
    TimeEstimate estimate(stop, good);
    estimate.left_s({});
    EXPECT_NEAR(estimate.left_s(half_filled()).value(), 10, 1e-3);
  }
}

TEST(TimeEstimate, TrialsGoAtTheirOwnPace) {
  TimeEstimate estimate({}, {.trials = 2000, .seconds = 0});
  master::Progress progress{.pieces = 200, .coverage = 0.93, .seconds = 20, .most_trials = 2000};
  estimate.left_s({});
  estimate.left_s(progress);
  progress.trials = 1;
  EXPECT_NEAR(estimate.left_s(progress).value(), 2000 * 2 * 0.1, 1e-3) << "by the pace of filling at first";
  progress.trials = 501;
  progress.seconds = 30;
  EXPECT_NEAR(estimate.left_s(progress).value(), 30, 0.1);
  progress.trials = 2000;
  EXPECT_LT(estimate.left_s(progress).value(), 1);
}

TEST(TimeEstimate, ImprovingMayHaveALimitInSeconds) {
  TimeEstimate estimate({}, {.trials = 0, .seconds = 60});
  estimate.left_s({});
  estimate.left_s({.pieces = 200, .coverage = 0.93, .seconds = 20});
  estimate.left_s({.pieces = 200, .coverage = 0.93, .seconds = 20, .trials = 1});
  EXPECT_NEAR(estimate.left_s({.pieces = 200, .coverage = 0.93, .seconds = 50, .trials = 99}).value(), 30, 1e-3);
}

/// The earlier attempts would make the estimate far too long.
TEST(TimeEstimate, AnAttemptIsNotJudgedByThoseBeforeIt) {
  TimeEstimate estimate({.pieces = 0, .coverage = 0.6f, .seconds = 0}, kNoTrials);
  estimate.left_s({});
  estimate.left_s({.pieces = 150, .coverage = 0.5, .seconds = 100});
  master::Progress second{.pieces = 1, .coverage = 0.006, .seconds = 101, .attempt = 2};
  EXPECT_EQ(estimate.left_s(second), std::nullopt);
  second.coverage = 0.303;
  second.seconds = 111;
  EXPECT_NEAR(estimate.left_s(second).value(), 10, 0.2);
}

TEST(TimeEstimate, WhatCameBeforeAnInterruptionSaysNothingOfThePace) {
  TimeEstimate estimate({.pieces = 0, .coverage = 0.6f, .seconds = 0}, kNoTrials);
  EXPECT_EQ(estimate.left_s({.pieces = 50, .coverage = 0.3, .seconds = 1000}), std::nullopt);
  EXPECT_NEAR(estimate.left_s({.pieces = 75, .coverage = 0.45, .seconds = 1001}).value(), 1, 1e-3);
}

RC_GTEST_PROP(TimeEstimate, is_never_negative, ()) {
  TimeEstimate estimate({}, {.trials = *rc::gen::inRange(0, 300), .seconds = double(*rc::gen::inRange(0, 5))});
  master::Progress progress;
  for (int i = 0; i < 60; ++i) {
    progress.seconds += *rc::gen::inRange(0, 3);
    progress.pieces += std::size_t(*rc::gen::inRange(0, 9));
    progress.coverage = std::min(1.0, progress.coverage + 0.01 * *rc::gen::inRange(0, 5));
    progress.trials += i < 30 ? 0 : std::uint64_t(*rc::gen::inRange(0, 9));
    const std::optional<double> left_s = estimate.left_s(progress);
    if (!left_s) continue;  // RC_ASSERT evaluates both sides of ||
    RC_ASSERT(*left_s >= 0);
    RC_ASSERT(*left_s < 1e7);
  }
}

}  // namespace test_time_estimate
}  // namespace tessera::cli
