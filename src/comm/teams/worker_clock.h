// Measures a worker's time in the loop, by stage.
#pragma once

#include <utility>

#include "comm/communicator.h"
#include "core/base/stopwatch.h"
#include "core/ranks/rank_statistics.h"

namespace tessera::comm {

class WorkerClock {
 public:
  explicit WorkerClock(const Communicator& ranks) : ranks_(ranks) { restart(); }

  /// A field begins. The first one begins the loop: the clock starts at zero. Later fields, of other regions or
  /// attempts at sizes, belong to the same loop.
  void begin_field() {
    if (!std::exchange(in_loop_, true)) restart();
  }

  /// Runs work() and adds its time to `stage`. On a rank with workers below it, this includes the wait for their
  /// answers.
  template <class Work>
  auto measure(double WorkerTimes::*stage, Work&& work) {
    const Charge charge{times_.*stage, waited_in_stages_s_, ranks_, ranks_.waited_s(), Stopwatch()};
    return work();
  }
  /// Measures work() in the same way, and counts the request.
  template <class Work>
  auto measure(double WorkerTimes::*stage, std::uint64_t WorkerTimes::*questions, Work&& work) {
    ++(times_.*questions);
    return measure(stage, work);
  }

  /// Ends the loop and returns its times. The next field begins another loop.
  WorkerTimes end_loop() {
    in_loop_ = false;
    WorkerTimes times = times_;
    times.loop_s = loop_.seconds();
    times.waiting_s = ranks_.waited_s() - waited_before_s_ - waited_in_stages_s_;
    times.messages_s = times.loop_s - times.waiting_s - times.count_s - times.dock_s - times.refine_s -
                       times.measure_s - times.replace_s - times.field_s;
    times.processor_s = busy_processor_s(ranks_) - processor_before_s_;
    const TrafficCount sent = ranks_.traffic().sent_in_loop();
    times.sent = {sent.messages - sent_before_.messages, sent.bytes - sent_before_.bytes};
    return times;
  }

 private:
  struct Charge {
    double& stage_s;
    double& waited_in_stages_s;
    const Communicator& ranks;
    double waited_before_s;
    Stopwatch watch;
    ~Charge() {
      stage_s += watch.seconds();
      waited_in_stages_s += ranks.waited_s() - waited_before_s;
    }
  };

  void restart() {
    times_ = {};
    waited_before_s_ = ranks_.waited_s();
    waited_in_stages_s_ = 0;
    processor_before_s_ = busy_processor_s(ranks_);
    sent_before_ = ranks_.traffic().sent_in_loop();
    loop_ = Stopwatch();
  }

  const Communicator& ranks_;
  bool in_loop_ = false;
  WorkerTimes times_;
  Stopwatch loop_;
  double waited_before_s_ = 0;
  double waited_in_stages_s_ = 0;
  double processor_before_s_ = 0;
  TrafficCount sent_before_;
};

}  // namespace tessera::comm
