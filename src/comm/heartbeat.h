// Signs of life that a worker sends to rank 0, whatever its main thread does: a rank that was stopped, whose node hangs
// or whose connection is cut sends none any more. They also tell what the main thread does, for faults that leave the
// process alive.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace tessera::comm {

class Communicator;

struct Heartbeat {
  bool waiting = false;  // for a message; else it computes
  double for_s = 0;      // since it last changed from one to the other; while the process is stopped, little is counted
};

/// Sends a heartbeat every tenth of `silence_s`, or more often, from a thread of its own, until it is destroyed.
/// Workers make it. The communicator outlives it; its transport must allow this (communicator.h).
class Heart {
 public:
  Heart(Communicator& ranks, double silence_s);

 private:
  void beat(const std::stop_token& stop, double period_s);

  Communicator& ranks_;
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::jthread thread_;  // the last member: it ends before the others go
};

}  // namespace tessera::comm
