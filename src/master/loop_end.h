// When the loop ends, and why: by the limits of the job's [stop], or by the observer, who asks it to stop.
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

  /// Seconds of the run, including the time before an interruption.
  double run_s() const { return earlier_s_ + own_s(); }
  /// Seconds of this call alone.
  double own_s() const { return watch_.seconds(); }
  /// Sets how many seconds the run took before it was interrupted.
  void go_on_after(double earlier_s) { earlier_s_ = earlier_s; }

  bool has_all_pieces(std::size_t pieces) const;
  bool is_covered(double covered_px2) const;
  /// Whether a limit is reached that ends both filling and improving: coverage or time. If so, the loop is over.
  bool reached_limit(double covered_px2);
  /// Whether any limit is reached that ends filling. If so, the loop is over.
  bool end_at_limit_of_filling(std::size_t pieces, double covered_px2);
  /// Throws Interrupted where the observer asks the loop to stop.
  void check_stop();

  /// Notes that the region is full, and why. The loop ends with this reason where no region follows.
  void region_is_full(StopReason reason) { full_ = reason; }
  /// Ends the loop: this limit is reached.
  void end_by(StopReason limit) { limit_ = limit; }
  /// Ends the loop: check_stop() or the matcher interrupted it.
  void interrupt(StopReason reason) { interruption_ = reason; }

  bool is_over() const { return limit_ || interruption_; }
  bool is_interrupted() const { return interruption_.has_value(); }
  /// Whether the matcher, and not check_stop(), threw Interrupted. The matcher must not be asked again then.
  bool matcher_interrupted() const { return is_interrupted() && !asked_to_stop_; }
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
