// The rules by which a worker counts as lost, tested with a simulated clock.
#include "comm/rank_watch.h"

#include <gtest/gtest.h>

namespace tessera::comm {
namespace test_rank_watch {

constexpr double kSilence_s = 10;
constexpr Heartbeat kBusy{.waiting = false, .for_s = 3};
constexpr Heartbeat kIdle{.waiting = true, .for_s = 0};

/// The watch of rank 0 in a job of three ranks.
class RankWatchTest : public testing::Test {
 protected:
  RankWatchTest() { watch_.begin_wait(); }

  /// Waits, and calls the watch ten times a second.
  void wait(double seconds) {
    for (int i = 0; i < int(10 * seconds); ++i) watch_.waited(0.1);
  }

  RankWatch watch_{3, kSilence_s};
};

TEST_F(RankWatchTest, nobody_is_lost_who_sends_heartbeats) {
  for (int i = 0; i < 100; ++i) {
    wait(1);
    watch_.heard(1, kBusy);
    watch_.heard(2, kIdle);
    EXPECT_FALSE(watch_.lost());
  }
}

TEST_F(RankWatchTest, the_silent_one_is_lost) {
  for (int i = 0; i < 9; ++i) {
    wait(1);
    watch_.heard(1, kBusy);
  }
  EXPECT_FALSE(watch_.lost());
  wait(2);
  ASSERT_TRUE(watch_.lost());
  EXPECT_EQ(watch_.lost()->rank, 2);
  EXPECT_EQ(watch_.lost()->what, "has not been heard of for 11 s");
}

TEST_F(RankWatchTest, silence_from_the_start_counts) {
  wait(10.5);
  ASSERT_TRUE(watch_.lost());
  EXPECT_EQ(watch_.lost()->rank, 1);
}

TEST_F(RankWatchTest, silence_counts_only_while_rank_0_waits) {
  for (int round = 0; round < 100; ++round) {  // each time it computes for a minute and then waits for a moment
    watch_.begin_wait();
    watch_.waited(0.05);
  }
  EXPECT_FALSE(watch_.lost());
}

TEST_F(RankWatchTest, a_job_that_was_suspended_as_a_whole_goes_on) {
  wait(5);
  watch_.heard(1, kBusy);
  watch_.heard(2, kBusy);
  watch_.waited(3600);
  EXPECT_FALSE(watch_.lost());
  wait(8);
  EXPECT_FALSE(watch_.lost());
}

TEST_F(RankWatchTest, a_worker_that_never_answers_is_lost) {
  watch_.heard(1, kIdle);
  watch_.heard(2, {.waiting = false, .for_s = RankWatch::kMostBusy * kSilence_s - 1});
  EXPECT_FALSE(watch_.lost());
  watch_.heard(2, {.waiting = false, .for_s = RankWatch::kMostBusy * kSilence_s + 1});
  ASSERT_TRUE(watch_.lost());
  EXPECT_EQ(watch_.lost()->rank, 2);
  EXPECT_EQ(watch_.lost()->what, "has been busy with one request for 601 s");
}

TEST_F(RankWatchTest, whoever_waits_for_an_hour_is_not_busy) {
  watch_.heard(1, {.waiting = true, .for_s = RankWatch::kMostBusy * kSilence_s + 1});
  EXPECT_FALSE(watch_.lost());
}

TEST_F(RankWatchTest, whoever_has_just_begun_to_wait_may_have_answered) {
  wait(6);
  watch_.heard(1, {.waiting = true, .for_s = 100});
  watch_.heard(2, {.waiting = true, .for_s = 0.5});
  wait(6);
  EXPECT_FALSE(watch_.lost()) << "the answer of rank 2 is on its way";
  watch_.heard(2, {.waiting = true, .for_s = 11});
  EXPECT_TRUE(watch_.lost());
}

TEST_F(RankWatchTest, a_message_that_all_wait_for_is_lost) {
  const auto all_idle_for = [&](double idle_s) {
    watch_.heard(1, {.waiting = true, .for_s = idle_s});
    watch_.heard(2, {.waiting = true, .for_s = idle_s});
  };
  all_idle_for(100);  // rank 0 computed in the meantime
  wait(9);
  EXPECT_FALSE(watch_.lost());
  all_idle_for(109);
  wait(2);
  ASSERT_TRUE(watch_.lost());
  EXPECT_EQ(watch_.lost()->rank, 0);
  watch_.heard(2, kBusy);
  EXPECT_FALSE(watch_.lost());
  watch_.begin_wait();
  all_idle_for(200);
  EXPECT_FALSE(watch_.lost());
}

}  // namespace test_rank_watch
}  // namespace tessera::comm
