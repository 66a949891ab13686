// The gain in the last tenth of a run.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "run/progress/collage_progress.h"

namespace tessera::cli {
namespace test_coverage_history {

TEST(CoverageHistory, says_what_the_last_tenth_brought) {
  CoverageHistory history;
  for (int s = 1; s <= 100; ++s) history.add(s, s <= 90 ? 0.01 * s : 0.9 + 0.002 * (s - 90));
  EXPECT_NEAR(history.gained_in_last_tenth(100).value(), 0.02, 1e-12);
  EXPECT_NEAR(history.gained_in_last_tenth(110).value(), 0.002, 1e-12) << "from the last moment up to 99 s";
}

TEST(CoverageHistory, pieces_that_were_taken_out_count) {
  CoverageHistory history;
  for (int s = 1; s <= 10; ++s) history.add(s, s < 10 ? 0.5 : 0.4);
  EXPECT_NEAR(history.gained_in_last_tenth(10).value(), -0.1, 1e-12);
}

TEST(CoverageHistory, growth_ends_with_the_latest_moment_and_has_no_more_than_wanted) {
  CoverageHistory history;
  EXPECT_TRUE(history.growth(10).empty());
  history.add(0, {});
  for (int s = 1; s <= 5000; ++s) history.add(s, 0.0001 * s);
  const std::vector<GrowthMoment> growth = history.growth(100);
  ASSERT_EQ(growth.size(), 100u);
  EXPECT_EQ(growth.back().seconds, 5000);
  EXPECT_NEAR(growth.back().coverage, 0.5, 1e-12);
  for (std::size_t k = 0; k < growth.size(); ++k) EXPECT_NEAR(growth[k].seconds, 50. * double(k + 1), 30);
}

TEST(CoverageHistory, does_not_say_what_it_does_not_know) {
  CoverageHistory history;
  EXPECT_FALSE(history.gained_in_last_tenth(1));
  for (int i = 0; i < 100; ++i) history.add(1000 + i, 0.9);  // this run was resumed
  EXPECT_FALSE(history.gained_in_last_tenth(1100));
  EXPECT_TRUE(history.gained_in_last_tenth(1200));
  CoverageHistory two;
  two.add(1, 0.1);
  two.add(9.5, 0.2);
  EXPECT_FALSE(two.gained_in_last_tenth(10)) << "a collage of two pieces is no curve";
}

TEST(CoverageHistory, what_was_not_known_then_was_no_gain) {
  CoverageHistory until_late, early, at_the_end;
  for (int s = 1; s <= 100; ++s) {
    const auto unless = [&](bool exchanging) { return exchanging ? std::nullopt : std::optional(0.01 * s); };
    until_late.add(s, unless(s > 20 && s <= 95));
    early.add(s, unless(s > 20 && s < 90));
    at_the_end.add(s, unless(s > 98));
  }
  EXPECT_FALSE(until_late.gained_in_last_tenth(100));
  EXPECT_NEAR(early.gained_in_last_tenth(100).value(), 0.1, 1e-12);
  EXPECT_FALSE(at_the_end.gained_in_last_tenth(100));
}

TEST(CoverageHistory, of_a_run_knows_nothing_while_pieces_are_exchanged) {
  for (const bool exchanging : {false, true}) {
    CollageProgress run({}, true);
    for (int s = 1; s <= 100; ++s) {
      master::Progress now;
      now.seconds = s;
      now.coverage = 0.01 * s;
      now.exchanging = exchanging && s < 98;
      run.progressed(now);
    }
    EXPECT_EQ(run.history().gained_in_last_tenth(100).has_value(), !exchanging);
  }
}

RC_GTEST_PROP(CoverageHistory, of_any_length_is_right_to_a_thousandth_of_its_time, ()) {
  const int moments = *rc::gen::inRange(1000, 60000);
  CoverageHistory history;
  for (int i = 1; i <= moments; ++i) history.add(i, double(i) / moments);
  RC_ASSERT(std::abs(history.gained_in_last_tenth(moments).value() - 0.1) < 1e-3);
}

}  // namespace test_coverage_history
}  // namespace tessera::cli
