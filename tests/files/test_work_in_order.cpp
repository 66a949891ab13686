// Results of several threads come in order, and an early end stops the work.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "files/work_in_order.h"

namespace tessera {
namespace test_work_in_order {

using namespace std::chrono_literals;

OrderedWork<std::string> numbers(std::size_t count, std::vector<std::string>& results) {
  OrderedWork<std::string> job;
  job.count = count;
  job.threads = 3;
  job.work = [](std::size_t i) { return std::to_string(i); };
  job.consume = [&](std::size_t i, std::string result) {
    EXPECT_EQ(i, results.size());
    results.push_back(std::move(result));
  };
  return job;
}

TEST(WorkInOrder, GivesResultsInOrder) {
  std::vector<std::string> results;
  OrderedWork<std::string> job = numbers(600, results);
  job.work = [](std::size_t i) {
    std::this_thread::sleep_for(std::chrono::microseconds(i * 7919 % 1000));
    return std::to_string(i);
  };
  work_in_order(job);
  ASSERT_EQ(results.size(), 600u);
  for (std::size_t i = 0; i < results.size(); ++i) ASSERT_EQ(results[i], std::to_string(i));
}

TEST(WorkInOrder, TakesNothing) {
  std::vector<std::string> results;
  work_in_order(numbers(0, results));
  EXPECT_TRUE(results.empty());
}

TEST(WorkInOrder, WaitsForASlowPieceWithABoundedNumberOfResults) {
  std::vector<std::string> results;
  OrderedWork<std::string> job = numbers(2000, results);
  std::atomic<std::size_t> furthest = 0;
  std::atomic<bool> first_done = false;
  job.work = [&](std::size_t i) {
    if (i == 0) {
      std::this_thread::sleep_for(200ms);
      first_done = true;
    } else if (!first_done) {
      furthest = std::max(furthest.load(), i);
    }
    return std::to_string(i);
  };
  work_in_order(job);
  EXPECT_EQ(results.size(), 2000u);
  EXPECT_LT(furthest, 256u);
}

TEST(WorkInOrder, EndsWhenTheConsumerThrows) {
  std::vector<std::string> results;
  OrderedWork<std::string> job = numbers(4, results);
  std::atomic<bool> stopped = false;
  job.consume = [](std::size_t, const std::string&) { throw std::runtime_error("disk full"); };
  job.stop = [&] { stopped = true; };
  EXPECT_THROW(work_in_order(job), std::runtime_error);
  EXPECT_TRUE(stopped);
}

TEST(WorkInOrder, WhatTheWorkThrowsComesInItsTurn) {
  std::vector<std::string> results;
  OrderedWork<std::string> job = numbers(4, results);
  job.work = [](std::size_t i) -> std::string {
    if (i == 2) throw std::runtime_error("no process");
    return "";
  };
  EXPECT_THROW(work_in_order(job), std::runtime_error);
  EXPECT_EQ(results.size(), 2u);
}

}  // namespace test_work_in_order
}  // namespace tessera
