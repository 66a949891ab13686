// The end of the loop, and its reason.
#include "master/loop_end.h"

#include <gtest/gtest.h>

namespace tessera::master {
namespace test_loop_end {

class AskedToStop : public SilentObserver {
 public:
  std::optional<StopReason> stop_requested() override { return answer; }
  std::optional<StopReason> answer;
};

class LoopEndTest : public testing::Test {
 protected:
  LoopEndTest() {
    settings_.stop.pieces = 10;
    settings_.stop.coverage = 0.5f;
    settings_.stop.seconds = 1000;
  }

  /// The canvas has 1,000 px².
  const Canvas canvas_ = make_rectangle_canvas(40, 25);
  CollageSettings settings_;
  AskedToStop observer_;
  LoopEnd end_{canvas_, settings_, observer_};
};

TEST_F(LoopEndTest, GoesOnBelowAllLimits) {
  EXPECT_FALSE(end_.end_at_limit_of_filling(9, 499));
  EXPECT_FALSE(end_.reached_limit(499));
  EXPECT_NO_THROW(end_.check_stop());
  EXPECT_FALSE(end_.is_over() || end_.is_interrupted() || end_.matcher_interrupted());
}

TEST_F(LoopEndTest, TheNumberOfPiecesEndsFillingAlone) {
  EXPECT_FALSE(end_.reached_limit(0));
  EXPECT_TRUE(end_.end_at_limit_of_filling(10, 0));
  EXPECT_TRUE(end_.is_over());
  EXPECT_EQ(end_.reason(), StopReason::pieces);
}

TEST_F(LoopEndTest, CoverageEndsIt) {
  EXPECT_TRUE(end_.reached_limit(500));
  EXPECT_EQ(end_.reason(), StopReason::coverage);
  EXPECT_FALSE(end_.reached_limit(400)) << "less is covered again";
  EXPECT_TRUE(end_.is_over());
}

TEST_F(LoopEndTest, TimeBeforeAnInterruptionCounts) {
  end_.go_on_after(999.999);
  EXPECT_GE(end_.run_s(), 999.999 + end_.own_s() - 1e-3);
  EXPECT_LT(end_.own_s(), 100);
  end_.go_on_after(1000);
  EXPECT_TRUE(end_.reached_limit(500));
  EXPECT_EQ(end_.reason(), StopReason::seconds) << "the later of both";
}

TEST_F(LoopEndTest, WithoutLimitsItEndsWhereTheRegionIsFull) {
  settings_.stop = {};
  EXPECT_FALSE(end_.end_at_limit_of_filling(1'000'000, 999));
  end_.region_is_full(StopReason::used_up);
  EXPECT_EQ(end_.reason(), StopReason::used_up);
  EXPECT_FALSE(end_.is_over()) << "another region may follow";
}

TEST_F(LoopEndTest, WhoAsksItToStopGivesNoQuestionUp) {
  observer_.answer = StopReason::time_limit;
  try {
    end_.check_stop();
    FAIL() << "did not stop";
  } catch (const Interrupted& interrupted) {
    EXPECT_EQ(interrupted.reason, StopReason::time_limit);
    end_.interrupt(interrupted.reason);
  }
  EXPECT_TRUE(end_.is_over() && end_.is_interrupted());
  EXPECT_FALSE(end_.matcher_interrupted());
}

TEST_F(LoopEndTest, AnyOtherInterruptionGaveAQuestionUp) {
  ASSERT_TRUE(end_.reached_limit(500));
  end_.interrupt(StopReason::lost_rank);
  EXPECT_TRUE(end_.matcher_interrupted());
  EXPECT_EQ(end_.reason(), StopReason::lost_rank) << "there is more to do than the limit allowed";
}

}  // namespace test_loop_end
}  // namespace tessera::master
