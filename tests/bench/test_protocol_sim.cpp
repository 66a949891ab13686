// The simulated protocol against times computed by hand.
#include "protocol_sim.h"

#include <gtest/gtest.h>

namespace tessera::bench {
namespace test_protocol_sim {

/// One round with one question of each kind: measure, count, dock, refine.
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

// A latency of 1 ms; the time for bytes is negligible.
constexpr Cluster kSlowNetwork{0.001, 1e12};

TEST(ProtocolSim, AsByHand) {
  RoundCosts ahead = by_hand(1);
  ahead.ahead_s = 0.04;
  RoundCosts noticed = by_hand(1);
  noticed.notice_s = 0.0002;
  const std::vector<SimulatedRound> rounds =
      simulate_rounds({{by_hand(1)}, {by_hand(2)}, {by_hand(4), 2}, {by_hand(4), 4}, {noticed}, {ahead}}, kSlowNetwork);
  // The worker updates the field from 1 to 4 ms, while the measure question is packed and sent. It then measures for 5.1 ms, and the answer
  // travels 1 ms: 10.1 ms.
  // Count: 1 ms to ask, 1 ms on the way, 100.1 ms of work, 1 ms back. Dock and refine take 50.1 and 20.1 ms of work.
  // The master joins four answers, 2 ms each, and works 10 ms by itself.
  EXPECT_NEAR(rounds[0].round_s, 0.0101 + 0.1031 + 0.0531 + 0.0231 + 4 * 0.002 + 0.010, 1e-6);
  EXPECT_NEAR(rounds[0].master_busy_s, 4 * (0.001 + 0.002) + 0.010, 1e-9);
  // The second worker is asked 1 ms after the first. Its answer comes 1 ms later, while the master joins the first one.
  EXPECT_NEAR(rounds[1].round_s, 0.0101 + 0.1031 + 0.0531 + 0.0231 + 4 * 2 * 0.002 + 0.010, 1e-6);
  EXPECT_NEAR(rounds[1].master_busy_s, 4 * 2 * 0.003 + 0.010, 1e-9);
  // A tree of four workers; the master asks two. It costs one more level of asking, latency and joining, but the master asks only half as
  // many.
  EXPECT_NEAR(rounds[2].master_busy_s, rounds[1].master_busy_s, 1e-9);
  EXPECT_GT(rounds[2].round_s, rounds[1].round_s + 4 * (0.001 + 0.002));
  EXPECT_NEAR(rounds[3].master_busy_s, 4 * 4 * 0.003 + 0.010, 1e-9);
  // The master sleeps once a question. The worker sleeps once a question if it is idle when the question comes; at the measure it is busy.
  EXPECT_NEAR(rounds[4].round_s - rounds[0].round_s, 0.0002 * 8, 2.1e-4);
  EXPECT_NEAR(rounds[5].round_s, rounds[0].round_s, 1e-6) << "it is done before the count comes back";
  EXPECT_NEAR(rounds[5].master_busy_s, rounds[0].master_busy_s + 0.04, 1e-9);
}

}  // namespace test_protocol_sim
}  // namespace tessera::bench
