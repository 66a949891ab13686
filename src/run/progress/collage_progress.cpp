#include "run/progress/collage_progress.h"

#include <cstdio>

#include "comm/stop_signals.h"
#include "core/base/count_text.h"
#include "core/base/stop.h"

namespace tessera {
namespace {

constexpr std::size_t kBarTotal = 1000;

}  // namespace

CollageProgress::CollageProgress(const CollageSettings& settings, bool quiet, const TimeLimit& limit)
    : estimate_(settings.stop, settings.improve),
      limit_(limit) {
  if (!quiet) bar_.emplace("collage", kBarTotal);
}

void CollageProgress::progressed(const master::Progress& progress) {
  history_.add(progress.seconds, progress.exchanging ? std::nullopt : std::optional(progress.coverage));
  if (!bar_) return;
  const std::optional<double> left_s = estimate_.left_s(progress);
  const double share = left_s && progress.seconds > 0 ? progress.seconds / (progress.seconds + *left_s) : 0;
  bar_->update(std::size_t(kBarTotal * share), progress_note(progress), left_s);
}

std::optional<StopReason> CollageProgress::stop_requested() {
  if (comm::stop_signalled()) return StopReason::signal;
  return limit_.near() ? std::optional(StopReason::time_limit) : std::nullopt;
}

std::string progress_note(const master::Progress& progress) {
  char text[120];
  const std::string pieces = count_text(std::size_t(progress.pieces), "piece");
  if (progress.trials > 0) {
    std::snprintf(text, sizeof text, "%s, %.1f %% covered, trial %llu", pieces.c_str(), 100 * progress.coverage,
                  static_cast<unsigned long long>(progress.trials));
    return progress.most_trials > 0 ? text + (" of " + std::to_string(progress.most_trials)) : text;
  }
  if (progress.attempt > 1) {
    std::snprintf(text, sizeof text, "%s, %.1f %% covered, attempt %d at other sizes, as some found no place",
                  pieces.c_str(), 100 * progress.coverage, progress.attempt);
    return text;
  }
  const double rate = progress.seconds > 0 ? double(progress.pieces) / progress.seconds : 0;
  std::snprintf(text, sizeof text, "%s, %.1f %% covered, %.1f pieces/s", pieces.c_str(), 100 * progress.coverage, rate);
  return text;
}

}  // namespace tessera
