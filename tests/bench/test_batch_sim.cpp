// The simulated batch of replacement trials against times computed by hand.
#include "batch_sim.h"

#include <gtest/gtest.h>

namespace tessera::bench {
namespace test_batch_sim {

/// Four windows that take 3, 2, 2 and 1 s.
ReplacingCase by_hand() {
  ReplacingCase c;
  c.master_s = 0.5;
  c.request_s = 0.01;
  c.unpack_s = 0.02;
  c.reply_s = 0.03;
  for (const std::uint32_t s : {1u, 3u, 2u, 2u}) c.windows.push_back({s * 100, double(s), 1, 1});
  return c;
}

// A latency of 1 ms; the time for bytes is negligible.
constexpr Cluster kSlowNetwork{0.001, 1e12};

TEST(BatchSim, AsByHand) {
  const ReplacingCase c = by_hand();
  ReplacingCase many;
  for (int i = 0; i < 10; ++i) many.windows.push_back({100, 1, 1, 1});
  const std::vector<BatchScenario> scenarios = {{&c, 1, 1}, {&c, 1, 2},    {&c, 2, 1},    {&c, 4, 1},
                                                {&c, 4, 8}, {&c, 2, 1, 1}, {&many, 1, 1}, {&many, 1, 2}};
  const std::vector<SimulatedBatch> found = simulate_batches(scenarios, kSlowNetwork);
  // The four windows are packed, sent, unpacked and tried; then the answers are packed, sent and unpacked.
  const double each_way_s = 4 * (0.01 + 0.02 + 0.03 + 0.03) + 0.002;
  EXPECT_NEAR(found[0].batch_s, 0.5 + each_way_s + 8, 1e-6);
  EXPECT_NEAR(found[0].master_busy_s, 0.5 + 4 * (0.01 + 0.03), 1e-9);
  // Two cores take 3 + 1 s and 2 + 2 s.
  EXPECT_NEAR(found[1].batch_s, 0.5 + each_way_s + 4, 1e-6);
  // Two workers get two windows each. The master asks the second one 20 ms after the first, and joins its answer first.
  EXPECT_NEAR(found[2].batch_s, 0.5 + 2 * 0.02 + 0.001 + 0.04 + 4 + 0.06 + 0.001 + 2 * 0.06, 1e-6);
  EXPECT_NEAR(found[2].master_busy_s, found[0].master_busy_s, 1e-9);
  // All wait for the largest window: its worker is asked first and joined last.
  EXPECT_NEAR(found[3].batch_s, 0.5 + 0.01 + 0.001 + 0.02 + 3 + 0.03 + 0.001 + 0.03, 1e-6);
  EXPECT_NEAR(found[4].batch_s, found[3].batch_s, 1e-6) << "more cores than windows bring nothing";
  // A chain: the first worker unpacks four windows, packs two for the second, joins its answer and packs all answers.
  EXPECT_NEAR(found[5].batch_s,
              0.5 + 0.04 + 0.001 + 0.08 + 0.02 + (0.001 + 0.04 + 4 + 0.06 + 0.001) + 0.06 + 0.12 + 0.001 + 0.12, 1e-6);
  // Each question holds eight windows for each core; the master asks for more when these are done.
  EXPECT_NEAR(found[6].batch_s, 8 + 2 + 2 * 0.002, 1e-6);
  EXPECT_NEAR(found[7].batch_s, 5 + 0.002, 1e-6);
}

}  // namespace test_batch_sim
}  // namespace tessera::bench
