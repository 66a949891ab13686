// A worker that rank 0 no longer hears of ends every wait of rank 0, and is reported once.
#include <gtest/gtest.h>

#include "comm/in_process_communicator.h"
#include "core/base/stop.h"

namespace tessera::comm {
namespace test_lost_worker {

TEST(LostWorker, IsToldOnceHoweverManyWaitsItEnds) {
  InProcessNetwork network(2);
  const std::unique_ptr<Communicator> master = network.connect(0);
  std::vector<std::string> told;
  master->watch_workers(0.05, [&](const std::string& line) { told.push_back(line); });
  for (int wait = 0; wait < 3; ++wait) EXPECT_THROW(master->receive(1, Tag::hello), Interrupted);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told.front().find("has not been heard of"), std::string::npos) << told.front();
}

TEST(LostWorker, StaysLostWhenItIsHeardOfAgain) {
  InProcessNetwork network(2);
  const std::unique_ptr<Communicator> master = network.connect(0), worker = network.connect(1);
  int told = 0;
  master->watch_workers(0.05, [&](const std::string&) { ++told; });
  EXPECT_THROW(master->receive(1, Tag::hello), Interrupted);
  worker->send_heartbeat({});
  EXPECT_THROW(master->receive(1, Tag::hello), Interrupted);
  EXPECT_TRUE(master->lost_a_worker());
  EXPECT_EQ(told, 1);
}

}  // namespace test_lost_worker
}  // namespace tessera::comm
