#include "core/replacing/replaced_windows.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <numeric>
#include <utility>

#include "core/replacing/window_trials.h"

namespace tessera {
namespace {

/// The time between two checks. A check takes some microseconds, and messages under way wait for it.
constexpr std::chrono::milliseconds kBetweenChecks{1};

/// Thrown through the trials of a window whose outcome is no longer needed.
struct GivenUp {};

/// The indices of the windows, those with most trials first, so that no long one is left for the end.
std::vector<std::size_t> longest_first(const std::vector<ReplacementWindow>& windows) {
  std::vector<std::size_t> order(windows.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return windows[a].trials > windows[b].trials; });
  return order;
}

/// The shared work on all windows. An idle thread helps with the candidates of unfinished windows (window_trials.cpp).
class WindowWork {
 public:
  WindowWork(const std::vector<ReplacementWindow>& windows, const HoleShapes& shapes, TaskPool& pool)
      : windows_(windows),
        shapes_(shapes),
        pool_(pool),
        order_(longest_first(windows)),
        outcomes_(windows.size()) {}

  void run() {
    pool_.run(order_.size(), [this](std::size_t k) { work_on(order_[k]); });
  }
  /// Makes run() end after the trials that are under way.
  void give_up() { given_up_ = true; }
  std::vector<ReplacementOutcome> take_outcomes() { return std::move(outcomes_); }

 private:
  void work_on(std::size_t i) {
    if (given_up_) return;
    const auto check_given_up = [this] {
      if (given_up_) throw GivenUp{};
    };
    try {
      outcomes_[i] = replaced(windows_[i], shapes_, check_given_up, pool_);
    } catch (const GivenUp&) {
    } catch (...) {
      give_up();
      throw;
    }
  }

  const std::vector<ReplacementWindow>& windows_;
  const HoleShapes& shapes_;
  TaskPool& pool_;
  std::vector<std::size_t> order_;
  std::vector<ReplacementOutcome> outcomes_;
  std::atomic<bool> given_up_ = false;
};

}  // namespace

std::vector<ReplacementOutcome> replaced_windows(const std::vector<ReplacementWindow>& windows,
                                                 const HoleShapes& shapes, TaskPool& pool,
                                                 const StopCheck& check_stop) {
  WindowWork work(windows, shapes, pool);
  // One thread more than the pool has: it computes in the place of this one. Deferred if the system gives no thread.
  std::future<void> worked = std::async(std::launch::async | std::launch::deferred, [&] { work.run(); });
  try {
    while (worked.wait_for(kBetweenChecks) == std::future_status::timeout) check_stop();
  } catch (...) {
    work.give_up();
    throw;  // after the destructor of `worked`, which waits
  }
  worked.get();
  return work.take_outcomes();
}

}  // namespace tessera
