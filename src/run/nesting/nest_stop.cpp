#include "run/nesting/nest_stop.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include "comm/stop_signals.h"
#include "core/base/stop.h"

namespace tessera {
namespace {

constexpr double kLeaving_s = 4;  // for several ranks, as for a collage
/// mpirun kills its ranks two seconds after a signal. The rest of this time is for one picture, and for leaving.
constexpr double kDrawingAfterSignal_s = 1.2;

}  // namespace

NestStop::NestStop(const std::optional<std::string>& argument, bool several_ranks)
    : was_asked_for_(argument.has_value()),
      leaving_s_(several_ranks ? kLeaving_s : 0),
      limit_(time_limit_s(argument, std::getenv("SLURM_JOB_END_TIME"), double(std::time(nullptr)), leaving_s_)) {}

bool NestStop::has_limit() const { return std::isfinite(limit_.seconds()); }

void NestStop::leave_time_for(double writing_s, double drawing_s) {
  constexpr double kMostOfWriting = 0.75, kMostOfBoth = 0.25;  // of the limit
  left_s_ = std::max(std::min(writing_s, kMostOfWriting * limit_.seconds()),
                     std::min(writing_s + drawing_s, kMostOfBoth * limit_.seconds()));
}

std::optional<StopReason> NestStop::search_over() {
  if (comm::stop_signalled()) return StopReason::signal;
  return limit_.must_end_round(leaving_s_ + left_s_) ? std::optional(StopReason::time_limit) : std::nullopt;
}

std::optional<StopReason> NestStop::writing_over() {
  return comm::stop_signalled_again() ? std::optional(StopReason::signal) : std::nullopt;
}

std::optional<StopReason> NestStop::must_end_drawing(std::size_t drawn) {
  if (comm::seconds_since_stop() > kDrawingAfterSignal_s) return StopReason::signal;
  return drawn > 0 && limit_.must_end_drawing(leaving_s_) ? std::optional(StopReason::time_limit) : std::nullopt;
}

double NestStop::search_left_s() const {
  return limit_.seconds() - reserve_s(limit_.seconds()) - leaving_s_ - left_s_ - watch_.seconds();
}

}  // namespace tessera
