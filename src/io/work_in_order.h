// Independent pieces of work on several threads, whose results are wanted in order.
#pragma once

#include <algorithm>
#include <chrono>
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

#include "core/base/error.h"

namespace tessera::io {

template <class Result>
struct OrderedWork {
  std::size_t count = 0;
  int threads = 1;
  std::function<Result(std::size_t index)> work;                  // called in any order, by any of the threads
  std::function<void(std::size_t index, Result result)> consume;  // called in order, by the calling thread
  std::function<bool()> interrupted = [] { return false; };       // asked several times a second
  std::function<void()> stop = [] {};  // called where it ends early: work under way shall throw soon
};

/// One run of work_in_order.
template <class Result>
class OrderedWorkers {
 public:
  explicit OrderedWorkers(const OrderedWork<Result>& job) : job_(job) {
    const std::size_t wanted = std::min(job.count, std::size_t(std::max(1, job.threads)));
    for (std::size_t i = 0; i < wanted; ++i) {
      try {
        threads_.emplace_back([this] { work(); });
      } catch (const std::system_error& error) {  // fewer threads do the same work
        if (threads_.empty()) throw EnvironmentError(std::string("cannot start a thread: ") + error.what());
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

  bool run() {
    while (consumed_ < job_.count) {
      if (job_.interrupted()) return false;
      if (auto outcome = next_outcome()) consume(std::move(*outcome));
    }
    return true;
  }

 private:
  using Outcome = std::variant<Result, std::exception_ptr>;

  /// How far the work may run ahead of a slow piece: that many results are held in memory.
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

  /// Nothing where the next one is not there after a moment.
  std::optional<Outcome> next_outcome() {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::milliseconds(100), [&] { return waiting_.contains(consumed_); });
    const auto next = waiting_.find(consumed_);
    if (next == waiting_.end()) return std::nullopt;
    std::optional<Outcome> outcome = std::move(next->second);
    waiting_.erase(next);
    return outcome;
  }

  void consume(Outcome outcome) {
    if (auto* error = std::get_if<std::exception_ptr>(&outcome)) std::rethrow_exception(*error);
    job_.consume(consumed_, std::move(std::get<Result>(outcome)));
    const std::lock_guard lock(mutex_);
    ++consumed_;
    changed_.notify_all();
  }

  const OrderedWork<Result>& job_;
  std::mutex mutex_;  // of all below; only the calling thread changes consumed_
  std::condition_variable changed_;
  std::map<std::size_t, Outcome> waiting_;  // finished, but an earlier one is not
  std::size_t given_ = 0;
  std::size_t consumed_ = 0;
  bool ended_ = false;
  std::vector<std::jthread> threads_;  // joined first
};

/// Does the work; returns false where `interrupted` ended it. What `work` or `consume` throws ends it and is thrown
/// again here. No thread outlives the call.
template <class Result>
bool work_in_order(const OrderedWork<Result>& job) {
  return OrderedWorkers<Result>(job).run();
}

}  // namespace tessera::io
