// Ends a process that a call of MPI holds up without end: these wait for other ranks, whether those were stopped, hang
// or were never started.
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
  /// `exit_code`. Time in which the process was suspended hardly counts, as in RankWatch. Infinite patience never ends.
  Watchdog(double patience_s, int exit_code, std::function<void()> report = {});
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  void watch(const std::stop_token& stop, double patience_s);

  std::mutex mutex_;
  std::condition_variable_any stopped_;
  int exit_code_;
  std::function<void()> report_;
  std::jthread thread_;  // the last member: it ends before the others go
};

/// Puts a Watchdog into `watchdog`. Where the system gives no further thread there is none: the process goes on
/// unwatched.
void start_if_possible(std::optional<Watchdog>& watchdog, double patience_s, int exit_code,
                       std::function<void()> report = {});

}  // namespace tessera::comm
