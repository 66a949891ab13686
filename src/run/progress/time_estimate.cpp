#include "run/progress/time_estimate.h"

#include <algorithm>

namespace tessera {
namespace {

constexpr double kMostShare = 0.99;     // an estimate never says that the run is over
constexpr double kLeastShare = 0.02;    // part of a phase that must be over to judge by
constexpr float kSurelyReached = 0.8f;  // coverage that any library but one of thin lines reaches
constexpr double kPiecesPerTrial = 2;   // a trial takes about as long as placing two pieces (jobs/animals.toml)

// Measured with jobs/animals.toml: coverage grows evenly up to about 0.9, which takes two thirds of the time. The rest goes
// into gaps where less and less fits. This is good enough to tell minutes from seconds.
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

bool ends_before_improving(const StopSettings& stop) { return stop.pieces > 0 || stop.coverage < kSurelyReached; }

double expected_time_share(const master::Progress& progress, const StopSettings& stop) {
  double share = share_by_coverage(progress.coverage, stop.coverage);
  if (stop.pieces > 0) share = std::max(share, double(progress.pieces) / stop.pieces);
  if (stop.seconds > 0) share = std::max(share, progress.seconds / stop.seconds);
  return std::clamp(share, 0.0, kMostShare);
}

TimeEstimate::Phase TimeEstimate::phase_of(const master::Progress& progress) {
  return {progress.attempt, progress.trials > 0};
}

double TimeEstimate::share_of_phase(const master::Progress& progress) const {
  if (!phase_.improving) return expected_time_share(progress, stop_);
  double share = 0;
  if (improve_.trials > 0) share = double(progress.trials) / improve_.trials;
  if (improve_.seconds > 0) share = std::max(share, (progress.seconds - begin_s_) / improve_.seconds);
  return std::min(share, kMostShare);
}

void TimeEstimate::begin(const Phase& phase, const master::Progress& progress) {
  phase_ = phase;
  begin_s_ = progress.seconds;
  begin_share_ = share_of_phase(progress);
  begin_pieces_ = progress.pieces;
}

void TimeEstimate::note_pace_of_filling(const master::Progress& progress) {
  if (progress.pieces > begin_pieces_)
    piece_s_ = (progress.seconds - begin_s_) / double(progress.pieces - begin_pieces_);
}

double TimeEstimate::improving_s() const {
  if (ends_before_improving(stop_)) return 0;
  const double by_trials_s = improve_.trials * kPiecesPerTrial * piece_s_;
  if (improve_.seconds <= 0) return by_trials_s;
  return improve_.trials > 0 ? std::min(improve_.seconds, by_trials_s) : improve_.seconds;
}

std::optional<double> TimeEstimate::left_s(const master::Progress& progress) {
  const Phase phase = phase_of(progress);
  if (phase != phase_) begin(phase, progress);
  if (!phase_.improving) note_pace_of_filling(progress);
  const double share = share_of_phase(progress);
  const double elapsed_s = progress.seconds - begin_s_;
  if (share - begin_share_ < kLeastShare) {
    if (phase_.improving && piece_s_ > 0) return std::max(0.0, improving_s() - elapsed_s);
    return std::nullopt;
  }
  const double phase_s = elapsed_s * (1 - share) / (share - begin_share_);
  return phase_.improving ? phase_s : phase_s + improving_s();
}

}  // namespace tessera
