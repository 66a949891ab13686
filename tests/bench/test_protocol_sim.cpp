// The simulated protocol against times that were worked out by hand.
#include "protocol_sim.h"

#include <gtest/gtest.h>

namespace tessera::bench {
namespace test_protocol_sim {

/// One measure, one count, one dock, one refine.
RoundCosts by_hand(int workers) {
  RoundCosts c;
  c.workers = workers;
  c.master_s = 0.010;
  c.ask_s = 0.001;
  c.join_s = 0.002;
  c.field_s = 0.003;
  c.count_s = 0.100;
  c.dock_s = 0.050;
  c.refine_s = 0.020;
  c.measure_s = 0.005;
  c.messages_s = 0.0001;
  c.field_bytes = c.request_bytes = c.reply_bytes = c.refine_request_bytes = c.refine_reply_bytes = 1;
  return c;
}

// A latency of 1 ms; a byte takes no time to speak of.
constexpr Cluster kSlowNetwork{0.001, 1e12};

TEST(ProtocolSim, AsByHand) {
  RoundCosts ahead = by_hand(1);
  ahead.ahead_s = 0.04;
  RoundCosts noticed = by_hand(1);
  noticed.notice_s = 0.0002;
  const std::vector<SimulatedRound> rounds =
      simulate_rounds({{by_hand(1)}, {by_hand(2)}, {by_hand(4), 2}, {by_hand(4), 4}, {noticed}, {ahead}}, kSlowNetwork);
  // The worker is at the field from 1 to 4 ms, while the measure is asked and comes; then it measures for 5.1 ms, and
  // the answer takes 1 ms: 10.1. Count: 1 ms to ask, 1 on the way, 100.1, 1 on the way; dock, refine: 50.1, 20.1.
  // Four answers joined, 2 ms each, and 10 ms of its own.
  EXPECT_NEAR(rounds[0].round_s, 0.0101 + 0.1031 + 0.0531 + 0.0231 + 4 * 0.002 + 0.010, 1e-6);
  EXPECT_NEAR(rounds[0].master_busy_s, 4 * (0.001 + 0.002) + 0.010, 1e-9);
  // The second worker is asked 1 ms after the first and answers 1 ms after it, while the first answer is joined.
  EXPECT_NEAR(rounds[1].round_s, 0.0101 + 0.1031 + 0.0531 + 0.0231 + 4 * 2 * 0.002 + 0.010, 1e-6);
  EXPECT_NEAR(rounds[1].master_busy_s, 4 * 2 * 0.003 + 0.010, 1e-9);
  // A tree of four with two asked by the master: a level more of asking, latency and joining; but it asks half as many.
  EXPECT_NEAR(rounds[2].master_busy_s, rounds[1].master_busy_s, 1e-9);
  EXPECT_GT(rounds[2].round_s, rounds[1].round_s + 4 * (0.001 + 0.002));
  EXPECT_NEAR(rounds[3].master_busy_s, 4 * 4 * 0.003 + 0.010, 1e-9);
  // The master sleeps once a question, the worker once a question where it is idle when it comes: not at the measure.
  EXPECT_NEAR(rounds[4].round_s - rounds[0].round_s, 0.0002 * 8, 2.1e-4);
  EXPECT_NEAR(rounds[5].round_s, rounds[0].round_s, 1e-6) << "it is done before the count comes back";
  EXPECT_NEAR(rounds[5].master_busy_s, rounds[0].master_busy_s + 0.04, 1e-9);
}

}  // namespace test_protocol_sim
}  // namespace tessera::bench
