// Decides when a nesting ends early: by a signal, by --time-limit, or by the end of the Slurm job.
#pragma once

#include <optional>
#include <string>

#include "core/base/stop.h"
#include "run/progress/time_limit.h"

namespace tessera {

/// Its time begins with its constructor.
class NestStop {
 public:
  /// `argument`: of --time-limit. `several_ranks`: keeps time for the ranks to leave. Throws InputError.
  NestStop(const std::optional<std::string>& argument, bool several_ranks);

  bool has_limit() const;
  /// Reserves time after the search to write the files of a layout (at most three quarters of the limit), and to draw its
  /// pictures, too, where both fit into a quarter. To be called before the search.
  void leave_time_for(double writing_s, double drawing_s);

  /// Whether the search shall end, so that its best layout can be written. Any thread may call it.
  std::optional<StopReason> search_over();
  /// Whether writing shall end and the layout is thrown away. Only a second signal asks for it (stop_signalled_again).
  std::optional<StopReason> writing_over();
  /// Whether drawing shall end after `drawn` pictures. The limit does not end the first picture, because most layouts have
  /// only one.
  std::optional<StopReason> must_end_drawing(std::size_t drawn);
  /// Seconds until the limit ends the search; infinite without a limit.
  double search_left_s() const;
  /// Whether the user gave the limit; reaching it is no interruption then.
  bool was_asked_for() const { return was_asked_for_; }

 private:
  bool was_asked_for_;
  double leaving_s_;
  double left_s_ = 0;  // reserved for the files
  TimeLimit limit_;
  Stopwatch watch_;
};

}  // namespace tessera
