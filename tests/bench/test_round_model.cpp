// The fitted costs of a round against runs with known costs.
#include "bench/round_model.h"

#include <gtest/gtest.h>

namespace tessera::bench {
namespace test_round_model {

/// Ten rounds of an invented machine. It counts 1 ms per thousand shapes, docks 40 ms over all workers, and its master takes 5 ms and 0.5
/// ms per worker.
ScalingCase made_up(int workers, std::uint32_t shapes) {
  ScalingCase c;
  c.workers = c.asked = workers;
  c.shapes = shapes;
  c.rounds = 10;
  c.samples = 500;
  c.counts = c.docks = c.refines = c.measures = 10;
  c.count_s = 0.010 * shapes / 1000. / workers;
  c.dock_s = 0.400 / workers;
  c.measure_s = 0.020 / workers;
  c.merge_s = 0.050;  // independent of the number of shapes
  c.questions_s = 0.005 * workers;
  c.field_bytes_to_worker = 1000;
  c.bytes_to_worker = 1000 + 4000 + 600. / workers;
  c.bytes_from_worker = 8000 + 1200. / workers;
  c.busiest_s = c.waiting_s = c.count_s + c.dock_s + c.measure_s;
  c.ahead_s = 0.010;
  c.waiting_s += 40 * 0.0003 - c.ahead_s;  // the master notices every answer late
  c.loop_s = c.waiting_s + c.ahead_s + c.merge_s + c.questions_s;
  return c;
}

RoundModel made_up_model() {
  return {{made_up(1, 1000), made_up(2, 1000), made_up(1, 2000), made_up(2, 2000)}, Clock::wall};
}

TEST(RoundModel, FindsWhatTheRunsWereMadeOf) {
  const RoundCosts costs = made_up_model().costs(10, 100'000);
  EXPECT_EQ(costs.counts, 1);
  EXPECT_NEAR(costs.count_s, 0.010, 1e-9);
  EXPECT_NEAR(costs.dock_s, 0.004, 1e-9);
  EXPECT_NEAR(costs.refine_s, 0, 1e-9);
  EXPECT_NEAR(costs.measure_s, 0.0002, 1e-9);
  EXPECT_NEAR(costs.master_s, 0.005, 1e-6);
  EXPECT_NEAR(costs.ahead_s, 0.001, 1e-6);
  EXPECT_NEAR(4 * (costs.ask_s + costs.join_s), 0.0005, 1e-6) << "four questions";
  EXPECT_NEAR(costs.notice_s, 0.0003 / 2, 1e-9);
  EXPECT_NEAR(costs.imbalance, 0, 1e-9);
  EXPECT_NEAR(costs.field_bytes, 100, 1e-6);
  EXPECT_NEAR(costs.request_bytes, 200, 1e-6);
  EXPECT_NEAR(costs.refine_request_bytes, 6, 1e-6);
  EXPECT_NEAR(costs.reply_bytes, 400, 1e-6);
  EXPECT_NEAR(costs.refine_reply_bytes, 12, 1e-6);
}

TEST(RoundModel, ProcessorTimeLeavesOutWhatOthersTook) {
  ScalingCase disturbed = made_up(1, 1000);
  disturbed.processor_s = disturbed.greatest_processor_s =
      (disturbed.count_s + disturbed.dock_s + disturbed.measure_s) / 2;
  disturbed.master_processor_s = 0.05 + disturbed.ahead_s;
  const RoundModel model({disturbed}, Clock::processor);
  EXPECT_NEAR(model.cases()[0].loop_s, disturbed.processor_s + 0.05, 1e-9);
  EXPECT_NEAR(model.cases()[0].serial_s(), 0.05, 1e-9) << "nor what is done while the workers dock";
  EXPECT_NEAR(model.cases()[0].dock_s, disturbed.dock_s / 2, 1e-9);
}

TEST(RoundModel, NoPartIsBelowZero) {
  const std::vector<double> x = fit_non_negative({{1, 1}, {1, 2}, {1, 4}}, {3, 2, 1});
  EXPECT_NEAR(x[0], 2, 1e-9) << "a falling line becomes the mean";
  EXPECT_EQ(x[1], 0);
}

}  // namespace test_round_model
}  // namespace tessera::bench
