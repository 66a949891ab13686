// Waits without blocking the core for others. Open MPI's blocking calls spin, but a master and its workers, with their
// device threads, often share a few cores. Therefore the caller polls often at first, then sleeps longer between polls.
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>

namespace tessera::comm {

/// One wait: make an object for each wait, and call pause() between polls.
class IdleWait {
 public:
  void pause() {
    if (std::chrono::steady_clock::now() - start_ < kSpin) {
      std::this_thread::yield();
      return;
    }
    std::this_thread::sleep_for(sleep_);
    sleep_ = std::min(2 * sleep_, kLongestSleep);
  }

  double waited_s() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  // About the time of a round trip between idle ranks on one node: shorter waits end without a sleep.
  static constexpr std::chrono::microseconds kSpin{20};
  // Linux adds about 55 us to each sleep. Measured: a waiting rank takes 4 % of a core, and a round trip between two
  // ranks costs 0.14 ms more than the work that it waits for.
  static constexpr std::chrono::microseconds kLongestSleep{100};

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::microseconds sleep_{5};
};

}  // namespace tessera::comm
