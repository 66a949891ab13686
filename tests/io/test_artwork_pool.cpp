// Work that hangs, crashes or eats the memory costs its own result only.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "io/library/artwork_pool.h"

namespace tessera::io {
namespace {

using namespace std::chrono_literals;

const PoolSettings kThree{.processes = 3, .seconds_per_input = 30, .bytes_per_process = std::size_t(256) << 20};
const auto kNever = [] { return false; };

std::vector<PoolResult> results_of(const std::vector<std::string>& inputs, const PoolWork& work,
                                   const PoolSettings& settings) {
  std::vector<PoolResult> results;
  const auto consume = [&](std::size_t index, PoolResult result) {
    EXPECT_EQ(index, results.size());  // in the order of the inputs
    results.push_back(std::move(result));
  };
  EXPECT_TRUE(work_in_processes(inputs, work, consume, settings, kNever));
  EXPECT_EQ(results.size(), inputs.size());
  return results;
}

void expect_no_children() {
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(ArtworkPool, GivesResultsInTheOrderOfTheInputs) {
  std::vector<std::string> inputs;
  for (int i = 0; i < 300; ++i) inputs.push_back(std::to_string(i));
  const auto work = [](const std::string& input) {
    std::this_thread::sleep_for(std::chrono::microseconds(std::stoi(input) * 7919 % 3000));
    return input + std::string(std::size_t(std::stoi(input)) * 1000, '.');
  };
  const auto results = results_of(inputs, work, kThree);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    ASSERT_TRUE(results[i].done);
    ASSERT_EQ(results[i].output, inputs[i] + std::string(i * 1000, '.'));
  }
  expect_no_children();
}

TEST(ArtworkPool, TakesNoInputs) {
  EXPECT_TRUE(results_of(
                  {}, [](const std::string& s) { return s; }, kThree)
                  .empty());
}

TEST(ArtworkPool, ExceptionsBecomeReasons) {
  const auto work = [](const std::string& input) -> std::string {
    if (input == "bad") throw std::runtime_error("not a drawing");
    return input;
  };
  const auto results = results_of({"a", "bad", "b"}, work, kThree);
  EXPECT_EQ(results[0].output, "a");
  EXPECT_FALSE(results[1].done);
  EXPECT_EQ(results[1].reason, "not a drawing");
  EXPECT_EQ(results[2].output, "b");
}

TEST(ArtworkPool, ReplacesWhatHangsOrDies) {
  const auto work = [](const std::string& input) -> std::string {
    if (input == "hang") std::this_thread::sleep_for(1h);
    if (input == "kill") ::raise(SIGKILL);
    if (input == "exit") ::_exit(3);
    return input;
  };
  PoolSettings settings = kThree;
  settings.seconds_per_input = 0.3;
  const auto results =
      results_of({"hang", "1", "kill", "2", "exit", "hang", "hang", "kill", "kill", "3"}, work, settings);
  for (const std::size_t i : {1, 3, 9}) EXPECT_TRUE(results[i].done) << i;
  for (const std::size_t i : {0, 5, 6}) EXPECT_EQ(results[i].reason, "took longer than 1 s") << i;
  for (const std::size_t i : {2, 7, 8}) EXPECT_EQ(results[i].reason, "crashed its process (Killed)") << i;
  EXPECT_EQ(results[4].reason, "its process ended");
  expect_no_children();
}

TEST(ArtworkPool, ACrashIsNamed) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer catches the signal";
#endif
  const auto results = results_of(
      {"x"},
      [](const std::string&) -> std::string {
        ::raise(SIGSEGV);
        return {};
      },
      kThree);
  EXPECT_EQ(results[0].reason, "crashed its process (Segmentation fault)");
}

TEST(ArtworkPool, BoundsTheMemory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's allocator aborts instead of throwing";
#endif
  const auto work = [](const std::string& input) {
    const std::vector<char> block(std::stoul(input) << 20, 'x');
    return std::string(1, block[block.size() / 2]);
  };
  PoolSettings settings = kThree;
  settings.bytes_per_process = std::size_t(64) << 20;
  const auto results = results_of({"32", "500", "32"}, work, settings);
  EXPECT_TRUE(results[0].done && results[2].done);
  EXPECT_EQ(results[1].reason, "needs more than 64 MiB of memory");
}

TEST(ArtworkPool, KeepsChildrenQuiet) {
  testing::internal::CaptureStderr();
  results_of(
      {"x"},
      [](const std::string& s) {
        std::fputs("noise of a decoder", stderr);
        return s;
      },
      kThree);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ArtworkPool, EndsWhenTheConsumerThrows) {
  const auto work = [](const std::string& input) { return input; };
  const auto consume = [](std::size_t, const PoolResult&) { throw std::runtime_error("disk full"); };
  EXPECT_THROW(work_in_processes({"a", "b", "c", "d"}, work, consume, kThree, kNever), std::runtime_error);
  expect_no_children();
}

TEST(ArtworkPool, EndsWhenInterrupted) {
  const auto start = std::chrono::steady_clock::now();
  const auto work = [](const std::string&) -> std::string {
    std::this_thread::sleep_for(1h);
    return {};
  };
  const auto soon = [&] { return std::chrono::steady_clock::now() - start > 200ms; };
  EXPECT_FALSE(work_in_processes(
      {"a", "b"}, work, [](std::size_t, const PoolResult&) {}, kThree, soon));
  EXPECT_LT(std::chrono::steady_clock::now() - start, 2s);
  expect_no_children();
}

}  // namespace
}  // namespace tessera::io
