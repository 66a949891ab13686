// When a nesting is to end before its time: by a signal, by --time-limit, or by the end of the Slurm job.
#pragma once

#include <optional>
#include <string>

#include "core/base/stop.h"
#include "run/progress/time_limit.h"

namespace tessera {

/// The time counts from the making of this object.
class NestStop {
 public:
  /// `argument`: of --time-limit. `several_ranks`: then there is time to leave, too. Throws InputError.
  NestStop(const std::optional<std::string>& argument, bool several_ranks);

  bool has_limit() const;
  /// To be called before the search, which leaves time for this: to write the files of a layout, three quarters of the
  /// limit at most, and to draw its pictures, too, where both fit into a quarter.
  void leave_time_for(double writing_s, double drawing_s);

  /// Whether the search is to end, so that its best can be written. By any thread.
  std::optional<StopReason> search_over();
  /// Whether writing the layout is to end, and what was searched is to be thrown away. Only a second signal
  /// asks for it (stop_signalled_again).
  std::optional<StopReason> writing_over();
  /// Whether drawing pictures, of which so many are done, is to end. The limit does not end the first one,
  /// which most layouts have alone.
  std::optional<StopReason> drawing_over(std::size_t drawn);
  /// Until a search ends by the limit; infinite without one.
  double search_left_s() const;
  /// Whether the user said how long it may take: then the end of that time is no interruption.
  bool was_asked_for() const { return was_asked_for_; }

 private:
  bool was_asked_for_;
  double leaving_s_;
  double left_s_ = 0;  // for the files
  TimeLimit limit_;
  Stopwatch watch_;
};

}  // namespace tessera
