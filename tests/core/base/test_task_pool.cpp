// Threads share tasks. Each task runs once, whichever thread takes it and whatever it throws; fewer threads give the same.
#include "core/base/task_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "support/room_for_stacks.h"

namespace tessera {
namespace test_task_pool {

TEST(TaskPool, EachTaskIsDoneOnceBeforeRunReturns) {
  for (const int breadth : {0, 1, 2, 5}) {
    TaskPool pool(breadth);
    EXPECT_EQ(pool.breadth(), std::max(1, breadth));
    for (const std::size_t count : {0, 1, 3, 100}) {
      std::vector<std::atomic<int>> times(count);
      pool.run(count, [&](std::size_t i) { ++times[i]; });
      for (const std::atomic<int>& n : times) EXPECT_EQ(n, 1);
    }
  }
}

TEST(TaskPool, AnotherThreadTakesTheSecondTask) {
  TaskPool pool(2);
  std::atomic<bool> second{false};
  // The first task ends when another thread has begun the second.
  pool.run(2, [&](std::size_t i) {
    if (i == 1) second = true;
    while (!second) std::this_thread::yield();
  });
  EXPECT_TRUE(second);
}

TEST(TaskPool, WhoCallsTakesTheFirstTask) {
  TaskPool pool(3);
  for (int round = 0; round < 50; ++round) {
    std::thread::id first;
    pool.run(4, [&](std::size_t i) {
      if (i == 0) first = std::this_thread::get_id();
    });
    EXPECT_EQ(first, std::this_thread::get_id());
  }
}

/// The largest number of tasks that run at a time. Each task waits a little for others.
int most_at_a_time(TaskPool& pool) {
  std::atomic<int> now{0};
  std::atomic<int> most{0};
  pool.run(40, [&](std::size_t) {
    const int here = ++now;
    for (int seen = most; here > seen && !most.compare_exchange_weak(seen, here);) {
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    --now;
  });
  return most;
}

TEST(TaskPool, AsManyTasksAtATimeAsItIsBroad) {
  TaskPool pool(3);
  EXPECT_EQ(most_at_a_time(pool), 3);
  pool.resize(1);
  EXPECT_EQ(most_at_a_time(pool), 1);
  pool.resize(2);
  EXPECT_EQ(most_at_a_time(pool), 2);
}

TEST(TaskPool, OfSeveralThreadsAndWithinEachOther) {
  TaskPool pool(4);
  std::atomic<int> done{0};
  {
    std::vector<std::jthread> busy;
    for (int k = 0; k < 4; ++k) {
      busy.emplace_back([&] {
        for (int round = 0; round < 50; ++round) {
          std::atomic<int> inner{0};
          pool.run(3, [&](std::size_t) { pool.run(4, [&](std::size_t) { ++inner; }); });
          if (inner == 12) ++done;
        }
      });
    }
  }
  EXPECT_EQ(done, 200);
}

TEST(TaskPool, WhoeverWaitsHelpsWithTheTasksOfItsTasks) {
  TaskPool pool(2);
  std::atomic<bool> third{false};
  // The second task runs on the other thread and ends when the third has begun. Only the first thread is left for the third.
  pool.run(2, [&](std::size_t i) {
    if (i == 0) return;
    pool.run(2, [&](std::size_t k) {
      if (k == 1) third = true;
      while (!third) std::this_thread::yield();
    });
  });
  EXPECT_TRUE(third);
}

TEST(TaskPool, AnIdleThreadIsKnown) {
  TaskPool pool(2);
  EXPECT_FALSE(pool.has_idle_thread());
  pool.run(2, [](std::size_t) {});
  while (!pool.has_idle_thread()) std::this_thread::yield();
  pool.resize(1);
  EXPECT_FALSE(pool.has_idle_thread());
}

TEST(TaskPool, WhatOneThrowsComesOutAndNoOtherBegins) {
  for (const int breadth : {1, 3}) {
    TaskPool pool(breadth);
    std::atomic<int> begun{0};
    const auto task = [&](std::size_t i) {
      ++begun;
      if (i == 2) throw std::runtime_error("one of them");
    };
    EXPECT_THROW(pool.run(1'000'000, task), std::runtime_error);
    EXPECT_LT(begun, 1'000'000);
    begun = 0;
    pool.run(2, task);
    EXPECT_EQ(begun, 2) << "the next ones are their own";
  }
}

TEST(TaskPool, FewerThreadsOrNoneDoTheSameWork) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer maps a shadow of all addresses";
#endif
  for (const int threads : {0, 1}) {
    TaskPool pool(4);
    {
      const test::RoomForStacks few(threads);
      std::array<std::atomic<int>, 100> done{};
      pool.run(done.size(), [&](std::size_t i) { ++done[i]; });
      EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](int times) { return times == 1; })) << threads;
    }
    EXPECT_EQ(most_at_a_time(pool), 4) << "it asks the system again";
  }
}

}  // namespace test_task_pool
}  // namespace tessera
