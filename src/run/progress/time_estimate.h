// Estimates how long a collage will take, from its pace so far.
#pragma once

#include <cstddef>
#include <optional>

#include "core/settings/settings.h"
#include "master/progress.h"

namespace tessera {

/// The part (0..0.99) of filling's time that is probably over, by the limit that comes first.
double expected_time_share(const master::Progress& progress, const StopSettings& stop);

/// Whether a limit of pieces, or of a coverage that filling usually reaches, leaves no time for improving.
bool ends_before_improving(const StopSettings& stop);

/// Estimates the rest of a run that fills, perhaps several times (fit = "all"), and then improves. It judges each of these
/// phases by its own pace in this process: earlier attempts and the time before an interruption do not count.
class TimeEstimate {
 public:
  TimeEstimate(const StopSettings& stop, const ImproveSettings& improve) : stop_(stop), improve_(improve) {}

  /// Seconds left. To be called with each progress in turn. Empty while it is too early to judge.
  std::optional<double> left_s(const master::Progress& progress);

 private:
  struct Phase {
    int attempt = 0;
    bool improving = false;
    friend bool operator==(const Phase&, const Phase&) = default;
  };

  static Phase phase_of(const master::Progress& progress);
  double share_of_phase(const master::Progress& progress) const;
  void begin(const Phase& phase, const master::Progress& progress);
  void note_pace_of_filling(const master::Progress& progress);
  double improving_s() const;

  StopSettings stop_;
  ImproveSettings improve_;
  Phase phase_;
  double begin_s_ = 0;      // of the phase, in this process
  double begin_share_ = 0;  // the part of the phase that was over then
  std::size_t begin_pieces_ = 0;
  double piece_s_ = 0;  // seconds a piece while filling
};

}  // namespace tessera
