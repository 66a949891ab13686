// Runs independent tasks on several threads and consumes their results in order. The threads are not part of the rank's
// thread pool (core/base/rank_pool.h): most of the time they wait for drawers, files and the consuming thread.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <variant>
#include <vector>

#include "core/base/process_limits.h"

namespace tessera {

template <class Result>
struct OrderedWork {
  std::size_t count = 0;
  int threads = 1;
  std::function<Result(std::size_t index)> work;                  // called in any order, by any of the threads
  std::function<void(std::size_t index, Result result)> consume;  // called in order, by the calling thread
  std::function<void()> stop = [] {};  // called on an early end: running tasks shall throw soon
};

/// One call of work_in_order.
template <class Result>
class OrderedWorkers {
 public:
  explicit OrderedWorkers(const OrderedWork<Result>& job) : job_(job) {
    const std::size_t wanted = std::min(job.count, std::size_t(std::max(1, job.threads)));
    for (std::size_t i = 0; i < wanted; ++i) {
      try {
        threads_.emplace_back([this] { work(); });
      } catch (const std::system_error& error) {  // fewer threads do the same work
        if (threads_.empty()) throw no_thread(error);
        break;
      }
    }
  }

  ~OrderedWorkers() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    changed_.notify_all();
    if (consumed_ < job_.count) job_.stop();
  }

  void run() {
    while (consumed_ < job_.count) consume(next_outcome());
  }

 private:
  using Outcome = std::variant<Result, std::exception_ptr>;

  /// Most tasks that may run ahead of a slow one; their results are kept in memory.
  static constexpr std::size_t kAhead = 256;

  void work() {
    while (const std::optional<std::size_t> index = next_index()) {
      Outcome outcome = outcome_of(*index);
      const std::lock_guard lock(mutex_);
      waiting_.emplace(*index, std::move(outcome));
      changed_.notify_all();
    }
  }

  std::optional<std::size_t> next_index() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return ended_ || given_ == job_.count || given_ < consumed_ + kAhead; });
    if (ended_ || given_ == job_.count) return std::nullopt;
    return given_++;
  }

  Outcome outcome_of(std::size_t index) {
    try {
      return job_.work(index);
    } catch (...) {
      return std::current_exception();
    }
  }

  Outcome next_outcome() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_.contains(consumed_); });
    return std::move(waiting_.extract(consumed_).mapped());
  }

  void consume(Outcome outcome) {
    if (auto* error = std::get_if<std::exception_ptr>(&outcome)) std::rethrow_exception(*error);
    job_.consume(consumed_, std::move(std::get<Result>(outcome)));
    const std::lock_guard lock(mutex_);
    ++consumed_;
    changed_.notify_all();
  }

  const OrderedWork<Result>& job_;
  std::mutex mutex_;  // guards all members below; only the calling thread changes consumed_
  std::condition_variable changed_;
  std::map<std::size_t, Outcome> waiting_;  // finished, waiting for an earlier one
  std::size_t given_ = 0;
  std::size_t consumed_ = 0;
  bool ended_ = false;
  std::vector<std::jthread> threads_;  // joined first, as the last member
};

/// Runs all tasks. An exception of `work` or `consume` ends them and is thrown again here. No thread outlives the call.
template <class Result>
void work_in_order(const OrderedWork<Result>& job) {
  OrderedWorkers<Result>(job).run();
}

}  // namespace tessera
