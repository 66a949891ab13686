#include "core/replacing/window_queue.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/replacing/window_trials.h"

namespace tessera {
namespace {

/// Thrown through the trials of a window that nobody wants any more.
struct GivenUp {};

}  // namespace

WindowQueue::WindowQueue(const std::vector<ReplacementWindow>& windows, const HoleShapes& shapes)
    : windows_(windows),
      shapes_(shapes),
      order_(windows.size()),
      outcomes_(windows.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t(0));
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return windows[a].trials > windows[b].trials; });
}

void WindowQueue::work() noexcept {
  try {
    for (std::size_t k = next_++; k < order_.size() && !given_up_; k = next_++) {
      const std::size_t i = order_[k];
      const StopCheck check_stop = [this] {
        if (given_up_) throw GivenUp{};
      };
      outcomes_[i] = replaced(windows_[i], shapes_, check_stop, tasks_);
      count_done();
    }
    tasks_.help();
  } catch (const GivenUp&) {
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::current_exception();
    give_up();
    ended_.notify_all();
  }
}

void WindowQueue::count_done() {
  const std::lock_guard lock(mutex_);
  if (++done_ < windows_.size()) return;
  ended_.notify_all();
  tasks_.close();
}

void WindowQueue::give_up() {
  given_up_ = true;
  tasks_.close();
}

bool WindowQueue::wait(std::chrono::milliseconds most) {
  std::unique_lock lock(mutex_);
  return ended_.wait_for(lock, most, [this] { return done_ == windows_.size() || error_; });
}

std::vector<ReplacementOutcome> WindowQueue::take_outcomes() {
  if (error_) std::rethrow_exception(error_);
  return std::move(outcomes_);
}

}  // namespace tessera
