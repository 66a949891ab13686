// When the loop ends, and why: the limits of the job's [stop], and who asks it to stop.
#pragma once

#include <cstddef>
#include <optional>

#include "core/base/stop.h"
#include "core/base/stopwatch.h"
#include "core/field/canvas.h"
#include "core/settings/settings.h"
#include "master/progress.h"

namespace tessera::master {

class LoopEnd {
 public:
  /// All arguments outlive it.
  LoopEnd(const Canvas& canvas, const CollageSettings& settings, Observer& observer)
      : canvas_(canvas),
        limits_(settings.stop),
        observer_(observer) {}

  /// Seconds of the run, with those before an interruption.
  double run_s() const { return earlier_s_ + own_s(); }
  /// Seconds of this call alone.
  double own_s() const { return watch_.seconds(); }
  /// The run took so long before it was interrupted.
  void go_on_after(double earlier_s) { earlier_s_ = earlier_s; }

  bool has_all_pieces(std::size_t pieces) const;
  bool is_covered(double covered_px2) const;
  /// Whether a limit is reached that ends filling and improving alike: of coverage or time. It ends the loop.
  bool reached_limit(double covered_px2);
  /// Whether any limit is reached that ends filling. It ends the loop.
  bool end_at_limit_of_filling(std::size_t pieces, double covered_px2);
  /// Throws Interrupted where the observer asks the loop to stop.
  void check_stop();

  /// The region is full, for this reason. It ends the loop where no region follows.
  void region_is_full(StopReason reason) { full_ = reason; }
  /// A limit is reached.
  void end_by(StopReason limit) { limit_ = limit; }
  /// The loop was interrupted: by check_stop(), or by whoever was asked a question.
  void interrupt(StopReason reason) { interruption_ = reason; }

  bool is_over() const { return limit_ || interruption_; }
  bool is_interrupted() const { return interruption_.has_value(); }
  /// Whether somebody else than check_stop() threw Interrupted, who must not be asked again.
  bool gave_up_question() const { return is_interrupted() && !asked_to_stop_; }
  StopReason reason() const { return interruption_.value_or(limit_.value_or(full_)); }

 private:
  const Canvas& canvas_;
  const StopSettings& limits_;
  Observer& observer_;
  double earlier_s_ = 0;
  Stopwatch watch_;
  StopReason full_ = StopReason::full;
  std::optional<StopReason> limit_;
  std::optional<StopReason> interruption_;
  bool asked_to_stop_ = false;  // by the observer
};

}  // namespace tessera::master
