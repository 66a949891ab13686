#include "cli/collage_progress.h"

#include <algorithm>
#include <cstdio>

#include "comm/stop_signals.h"

namespace tessera::cli {
namespace {

constexpr std::size_t kBarTotal = 1000;
constexpr double kMostShare = 0.99;  // an estimate never says that it is over

// Measured with jobs/animals.toml: coverage grows evenly up to about 0.9, which takes two thirds of the time; the rest
// goes by over gaps where less and less fits. Near enough to tell minutes from seconds.
constexpr double kEvenCoverage = 0.9;
constexpr double kEvenTimeShare = 0.67;
constexpr double kUsualFullCoverage = 0.94;

double share_by_coverage(double coverage, double goal) {
  if (goal <= kEvenCoverage) return coverage / goal;
  if (coverage <= kEvenCoverage) return kEvenTimeShare * coverage / kEvenCoverage;
  const double late = (coverage - kEvenCoverage) / (std::min(goal, kUsualFullCoverage) - kEvenCoverage);
  return kEvenTimeShare + (1 - kEvenTimeShare) * late;
}

}  // namespace

CollageProgress::CollageProgress(const StopSettings& stop, bool quiet, const TimeLimit& limit)
    : stop_(stop),
      limit_(limit) {
  if (!quiet) bar_.emplace("collage", kBarTotal);
}

void CollageProgress::progressed(const master::Progress& progress) {
  if (bar_) bar_->update(std::size_t(kBarTotal * expected_time_share(progress, stop_)), progress_note(progress));
}

const char* CollageProgress::stop_requested() {
  if (comm::stop_signalled()) return "signal";
  return limit_.near() ? "time_limit" : nullptr;
}

double expected_time_share(const master::Progress& progress, const StopSettings& stop) {
  double share = share_by_coverage(progress.coverage, stop.coverage);
  if (stop.pieces > 0) share = std::max(share, double(progress.pieces) / stop.pieces);
  if (stop.seconds > 0) share = std::max(share, progress.seconds / stop.seconds);
  return std::clamp(share, 0.0, kMostShare);
}

std::string progress_note(const master::Progress& progress) {
  char text[120];
  const std::string pieces = std::to_string(progress.pieces) + (progress.pieces == 1 ? " piece" : " pieces");
  if (progress.trials > 0) {
    std::snprintf(text, sizeof text, "%s, %.1f %% covered, trial %llu", pieces.c_str(), 100 * progress.coverage,
                  static_cast<unsigned long long>(progress.trials));
    return progress.most_trials > 0 ? text + (" of " + std::to_string(progress.most_trials)) : text;
  }
  if (progress.attempt > 1) {
    std::snprintf(text, sizeof text, "%s, %.1f %% covered, attempt %d with smaller pieces, as some found no place",
                  pieces.c_str(), 100 * progress.coverage, progress.attempt);
    return text;
  }
  const double rate = progress.seconds > 0 ? double(progress.pieces) / progress.seconds : 0;
  std::snprintf(text, sizeof text, "%s, %.1f %% covered, %.1f pieces/s", pieces.c_str(), 100 * progress.coverage, rate);
  return text;
}

}  // namespace tessera::cli
