// When a run must be over: by --time-limit, or by the end of the Slurm job that it is part of.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "core/base/stopwatch.h"

namespace tessera {

/// The limit in seconds, more than 0: "90" and "90.5" are seconds, "90m" and "2h" say so; "MM:SS", "HH:MM:SS", "D-HH",
/// "D-HH:MM" and "D-HH:MM:SS" are as in sbatch's --time; "UNLIMITED" and "INFINITE", in any case, are infinite. Throws
/// InputError.
double parse_time_limit(const std::string& text);

/// `argument` as parse_time_limit takes it, which must leave something beside the reserve and `leaving_s` (InputError);
/// without one, from `now_s` to `slurm_end_time`, both in seconds since 1970; infinite where that is null, no number or
/// over.
double time_limit_s(const std::optional<std::string>& argument, const char* slurm_end_time, double now_s,
                    double leaving_s);

/// The warning of a limit that leaves nothing beside the reserve, which can only be a Slurm job's, since time_limit_s
/// refuses others. Empty where the limit does leave something.
std::string short_limit_warning(double limit_s, double leaving_s);

/// A limit that counts from the making of this object.
class TimeLimit {
 public:
  explicit TimeLimit(double limit_s = std::numeric_limits<double>::infinity()) : limit_s_(limit_s) {}

  double seconds() const { return limit_s_; }
  /// Asked before every round and while a piece is chosen: another wait as long as the longest so far between two
  /// questions, and the files of the result, might come to an end too late.
  bool near();
  /// Asked within a round: what is left is needed for the files of the result, and `leaving_s` to leave.
  bool round_over(double leaving_s) const;
  /// Asked while the result is drawn, from any thread: it is time to end, and to leave.
  bool drawing_over(double leaving_s) const;

 private:
  double limit_s_;
  double asked_s_ = 0;
  double longest_wait_s_ = 0;
  Stopwatch watch_;
};

/// What is kept for the last checkpoint and the files of the result; not for its pictures, which can be drawn later.
double reserve_s(double limit_s);

}  // namespace tessera
