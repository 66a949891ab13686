// Decides when a run must be over: by --time-limit, or by the end of its Slurm job.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "core/base/stopwatch.h"

namespace tessera {

/// Reads a limit in seconds, more than 0. "90" and "90.5" are seconds; "90m" and "2h" name their unit; "MM:SS", "HH:MM:SS",
/// "D-HH", "D-HH:MM" and "D-HH:MM:SS" are read like sbatch's --time; "UNLIMITED" and "INFINITE", in any case, are infinite.
/// Throws InputError.
double parse_time_limit(const std::string& text);

/// The limit in seconds: `argument`, read by parse_time_limit(), or, without one, the time from `now_s` to `slurm_end_time`
/// (both in seconds since 1970). An argument that leaves nothing beside the reserve and `shutdown_s` is refused
/// (InputError). Infinite where `slurm_end_time` is null, no number or in the past.
double time_limit_s(const std::optional<std::string>& argument, const char* slurm_end_time, double now_s,
                    double shutdown_s);

/// Warns of a limit that leaves nothing beside the reserve. It can only come from a Slurm job, because time_limit_s()
/// refuses such arguments. Otherwise empty.
std::string short_limit_warning(double limit_s, double shutdown_s);

/// A limit that counts from its constructor.
class TimeLimit {
 public:
  explicit TimeLimit(double limit_s = std::numeric_limits<double>::infinity()) : limit_s_(limit_s) {}

  double seconds() const { return limit_s_; }
  /// Whether it is time to end; called before every round and while a piece is chosen. True when another wait, as long as
  /// the longest between two calls so far, and the files of the result might not end in time.
  bool near();
  /// Whether a round must end, because the rest of the time is needed for the files of the result, and `shutdown_s` to
  /// leave. Called within a round.
  bool must_end_round(double shutdown_s) const;
  /// Whether drawing must end, with `shutdown_s` to leave. Called from any thread while the result is drawn.
  bool must_end_drawing(double shutdown_s) const;

 private:
  double limit_s_;
  double asked_s_ = 0;
  double longest_wait_s_ = 0;
  Stopwatch watch_;
};

/// Seconds that are kept for the last checkpoint and the files of the result. Its pictures can be drawn later.
double reserve_s(double limit_s);

}  // namespace tessera
