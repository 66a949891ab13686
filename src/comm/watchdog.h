// Ends a process that a call of MPI blocks for too long. Such calls wait for other ranks, even where these were
// stopped, hang or were never started.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace tessera::comm {

class Watchdog {
 public:
  /// Unless this object is destroyed within `patience_s`, a thread of its own calls `report` and ends the process with
  /// `exit_code`. Time in which the process was suspended hardly counts, as in RankWatch. With infinite patience
  /// nothing happens.
  Watchdog(double patience_s, int exit_code, std::function<void()> report = {});
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  void watch(const std::stop_token& stop, double patience_s);

  std::mutex mutex_;
  std::condition_variable_any stopped_;
  int exit_code_;
  std::function<void()> report_;
  std::jthread thread_;  // last member, so it ends before the others are destroyed
};

/// Puts a Watchdog into `watchdog`. Where the system refuses another thread `watchdog` stays empty, and nothing watches
/// the process.
void start_if_possible(std::optional<Watchdog>& watchdog, double patience_s, int exit_code,
                       std::function<void()> report = {});

}  // namespace tessera::comm
