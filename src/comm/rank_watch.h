// Finds lost workers from their heartbeats, on rank 0. It has no clock: the caller tells it how long it has waited, so
// that tests need no real time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comm/heartbeat.h"

namespace tessera::comm {

class RankWatch {
 public:
  /// A worker may be silent for `silence_s` while rank 0 waits, and may compute one request for kMostBusy times that.
  RankWatch(int ranks, double silence_s);

  /// Rank 0 begins to wait for a message.
  void begin_wait() { this_wait_s_ = 0; }
  /// Rank 0 has waited `seconds` longer and has taken in all that arrived. A long pause between two polls counts as
  /// kMostAtOnce_s: the process was suspended then, and probably all others with it.
  void waited(double seconds);
  void heard(int rank, const Heartbeat& beat);

  struct Lost {
    int rank;          // 0: no single rank
    std::string what;  // e.g. "has not been heard of for 60 s"
  };
  std::optional<Lost> lost() const;

  static constexpr double kMostBusy = 60;  // an hour with the default silence of a minute
  static constexpr double kMostAtOnce_s = 0.5;

 private:
  struct Seen {
    double at_s = 0;  // in seconds of clock_s_
    Heartbeat beat;
  };
  bool all_wait() const;

  double silence_s_;
  double clock_s_ = 0;  // runs while rank 0 waits
  double this_wait_s_ = 0;
  std::vector<Seen> seen_;  // of ranks 1 and up
};

}  // namespace tessera::comm
