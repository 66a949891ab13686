#include "cli/nest_stop.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include "comm/stop_signals.h"

namespace tessera::cli {
namespace {

constexpr double kLeaving_s = 4;  // of several ranks, as of a collage
/// mpirun kills its ranks two seconds after a signal; a file, and leaving, take the rest. A process alone has more time
/// for many sheets.
constexpr double kWritingAfterSignal_s = 1.2, kWritingAlone_s = 10;

}  // namespace

NestStop::NestStop(const std::optional<std::string>& argument, bool several_ranks)
    : was_asked_for_(argument.has_value()),
      leaving_s_(several_ranks ? kLeaving_s : 0),
      writing_after_signal_s_(several_ranks ? kWritingAfterSignal_s : kWritingAlone_s),
      limit_(time_limit_s(argument, std::getenv("SLURM_JOB_END_TIME"), double(std::time(nullptr)), leaving_s_)) {}

void NestStop::leave_time_for(std::size_t points, double sheets) {
  constexpr double kOfPoint_s = 2e-6, kOfSheet_s = 0.15;
  writing_s_ = std::min(kOfPoint_s * double(points) + kOfSheet_s * sheets, limit_.seconds() / 4);
}

bool NestStop::is_signalled() {
  if (!comm::stop_signalled()) return false;
  double nobody = -1;
  signalled_s_.compare_exchange_strong(nobody, watch_.seconds());
  return true;
}

const char* NestStop::search_over() {
  if (is_signalled()) return "signal";
  return limit_.round_over(leaving_s_ + writing_s_) ? "time_limit" : nullptr;
}

const char* NestStop::writing_over() {
  return is_signalled() && watch_.seconds() - signalled_s_ > writing_after_signal_s_ ? "signal" : nullptr;
}

const char* NestStop::drawing_over(std::size_t drawn) {
  if (is_signalled() && watch_.seconds() - signalled_s_ > kWritingAfterSignal_s) return "signal";
  return drawn > 0 && limit_.drawing_over(leaving_s_) ? "time_limit" : nullptr;
}

double NestStop::search_left_s() const {
  return limit_.seconds() - reserve_s(limit_.seconds()) - leaving_s_ - writing_s_ - watch_.seconds();
}

}  // namespace tessera::cli
