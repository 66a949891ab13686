// Heartbeats that a worker sends to rank 0, whatever its main thread does. They end when the rank was stopped, its node
// hangs or its connection is cut. They also say what the main thread does, for faults in which the process stays alive.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace tessera::comm {

class Communicator;

struct Heartbeat {
  bool waiting = false;  // true: it waits for a message; false: it computes
  double for_s = 0;      // time since `waiting` last changed; time in which the process is stopped hardly counts
};

/// Sends a heartbeat every tenth of `silence_s`, or more often, from a thread of its own until it is destroyed. For
/// workers. The communicator must outlive it and must allow sending from two threads (communicator.h).
class HeartbeatSender {
 public:
  HeartbeatSender(Communicator& ranks, double silence_s);

 private:
  void send_until_stopped(const std::stop_token& stop, double period_s);

  Communicator& ranks_;
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::jthread thread_;  // last member, so it ends before the others are destroyed
};

}  // namespace tessera::comm
