#include "comm/watchdog.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "comm/rank_watch.h"
#include "core/base/stopwatch.h"

namespace tessera::comm {

Watchdog::Watchdog(double patience_s, int exit_code, std::function<void()> report)
    : exit_code_(exit_code),
      report_(std::move(report)),
      thread_([this, patience_s](const std::stop_token& stop) { watch(stop, patience_s); }) {}

void Watchdog::watch(const std::stop_token& stop, double patience_s) {
  constexpr std::chrono::milliseconds kLook{100};
  std::unique_lock lock(mutex_);
  Stopwatch since_look;
  for (double waited_s = 0; waited_s < patience_s;) {
    stopped_.wait_for(lock, stop, kLook, [] { return false; });
    if (stop.stop_requested()) return;
    waited_s += std::min(since_look.lap(), RankWatch::kMostAtOnce_s);
  }
  if (report_) report_();
  std::fflush(nullptr);
  std::_Exit(exit_code_);
}

void start_if_possible(std::optional<Watchdog>& watchdog, double patience_s, int exit_code,
                       std::function<void()> report) {
  try {
    watchdog.emplace(patience_s, exit_code, std::move(report));
  } catch (const std::system_error&) {
  }
}

}  // namespace tessera::comm
