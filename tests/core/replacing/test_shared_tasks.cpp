// Tasks that threads do together: each once, whoever helps, and whatever they throw.
#include "core/replacing/shared_tasks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace tessera {
namespace test_shared_tasks {

class Helpers {
 public:
  Helpers(SharedTasks& tasks, int count) : tasks_(tasks) {
    for (int k = 0; k < count; ++k) threads_.emplace_back([this] { tasks_.help(); });
    while (count > 0 && !tasks_.has_helpers()) std::this_thread::yield();
  }
  ~Helpers() { tasks_.close(); }

 private:
  SharedTasks& tasks_;
  std::vector<std::jthread> threads_;
};

TEST(SharedTasks, EachIsDoneOnceBeforeRunReturns) {
  for (const int helpers : {0, 1, 4}) {
    SharedTasks tasks;
    const Helpers threads(tasks, helpers);
    for (const std::size_t count : {0, 1, 3, 100}) {
      std::vector<std::atomic<int>> times(count);
      tasks.run(count, [&](std::size_t i) { ++times[i]; });
      for (const std::atomic<int>& n : times) EXPECT_EQ(n, 1);
    }
  }
}

TEST(SharedTasks, HelpersHelp) {
  SharedTasks tasks;
  const Helpers threads(tasks, 1);
  std::atomic<bool> second{false};
  // The first ends when another thread has begun the second.
  tasks.run(2, [&](std::size_t i) {
    if (i == 1) second = true;
    while (!second) std::this_thread::yield();
  });
  EXPECT_TRUE(second);
}

TEST(SharedTasks, OfSeveralThreadsAndWithinEachOther) {
  SharedTasks tasks;
  const Helpers threads(tasks, 3);
  std::atomic<int> done{0};
  {
    std::vector<std::jthread> busy;
    for (int k = 0; k < 4; ++k) {
      busy.emplace_back([&] {
        for (int round = 0; round < 50; ++round) {
          std::atomic<int> inner{0};
          tasks.run(3, [&](std::size_t) { tasks.run(4, [&](std::size_t) { ++inner; }); });
          if (inner == 12) ++done;
        }
      });
    }
  }
  EXPECT_EQ(done, 200);
}

TEST(SharedTasks, WhatOneThrowsComesOutAndTheOthersAreDone) {
  for (const int helpers : {0, 2}) {
    SharedTasks tasks;
    const Helpers threads(tasks, helpers);
    std::atomic<int> done{0};
    const auto task = [&](std::size_t i) {
      if (i % 3 == 1) throw std::runtime_error("one of them");
      ++done;
    };
    EXPECT_THROW(tasks.run(9, task), std::runtime_error);
    EXPECT_EQ(done, 6);
    tasks.run(1, task);
    EXPECT_EQ(done, 7) << "the next ones are their own";
  }
}

TEST(SharedTasks, WhoHelpsEndsWhenTheyAreClosed) {
  SharedTasks tasks;
  { const Helpers threads(tasks, 3); }
  EXPECT_FALSE(tasks.has_helpers());
  std::thread late([&] { tasks.help(); });
  late.join();
  int done = 0;
  tasks.run(2, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 2) << "whoever has tasks does them";
}

}  // namespace test_shared_tasks
}  // namespace tessera
