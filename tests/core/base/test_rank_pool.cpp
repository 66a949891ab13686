// A rank computes on the cores of its process, or on a part of them if ranks share them.
#include "core/base/rank_pool.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <stdexcept>
#include <string>

#include "support/rank_breadth.h"

namespace tessera {
namespace test_rank_pool {

int cores_of_process() {
  cpu_set_t mask;
  return sched_getaffinity(0, sizeof mask, &mask) == 0 ? CPU_COUNT(&mask) : 0;
}

TEST(RankPool, HasTheCoresOfTheProcess) { EXPECT_EQ(rank_cores(), cores_of_process()); }

TEST(RankPool, RanksThatShareCoresHaveAPartEach) {
  const test::RankBreadth before(1);  // restores the breadth afterwards
  share_cores(1);
  EXPECT_EQ(rank_cores(), cores_of_process());
  share_cores(2);
  EXPECT_EQ(rank_cores(), std::max(1, cores_of_process() / 2));
  share_cores(1'000'000);
  EXPECT_EQ(rank_cores(), 1);
}

TEST(RankPool, PortionsCoverAllItems) {
  const test::RankBreadth rank(3);
  for (const std::size_t count : {0, 1, 7, 64, 65}) {
    std::vector<std::atomic<int>> times(count);
    parallel_for_portions(count, 16, [&](std::size_t i) { ++times[i]; });
    for (const std::atomic<int>& n : times) EXPECT_EQ(n, 1);
  }
}

TEST(RankPool, BothAreCalled) {
  for (const int cores : {1, 2}) {
    const test::RankBreadth rank(cores);
    std::string here, beside;
    run_both([&] { here = "here"; }, [&] { beside = "beside"; });
    EXPECT_EQ(here + " " + beside, "here beside");
    EXPECT_THROW(run_both([] {}, [] { throw std::runtime_error("beside"); }), std::runtime_error);
  }
}

}  // namespace test_rank_pool
}  // namespace tessera
