// Windows on which several threads work at a time, each on one after the other: those with most trials first, so that
// none is left at the end. Who finds none left helps with the trials of the others.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <vector>

#include "core/replacing/replacement.h"
#include "core/replacing/shared_tasks.h"
#include "core/replacing/window_pieces.h"

namespace tessera {

class WindowQueue {
 public:
  /// Both outlive it. `shapes` has those of all windows.
  WindowQueue(const std::vector<ReplacementWindow>& windows, const HoleShapes& shapes);

  /// Works until no window is left, and helps until all are done; or until one has failed, or give_up() was called. For
  /// any number of threads.
  void work() noexcept;
  /// Those who work end after the trials that they are at.
  void give_up();

  /// Waits until all windows are done or one has failed, but no longer than this; whether it is so.
  bool wait(std::chrono::milliseconds most);
  /// Of the windows, in their order. To be called when nobody works any more; throws what a window threw.
  std::vector<ReplacementOutcome> take_outcomes();

 private:
  void count_done();

  const std::vector<ReplacementWindow>& windows_;
  const HoleShapes& shapes_;
  std::vector<std::size_t> order_;  // of the windows, in which they are begun
  std::vector<ReplacementOutcome> outcomes_;
  SharedTasks tasks_;  // of trials
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> given_up_{false};
  std::mutex mutex_;  // of what follows
  std::condition_variable ended_;
  std::size_t done_ = 0;
  std::exception_ptr error_;
};

}  // namespace tessera
