// How long a collage will probably take, from how it has gone so far.
#pragma once

#include <cstddef>
#include <optional>

#include "core/settings/settings.h"
#include "master/progress.h"

namespace tessera {

/// The share of filling's time that is probably over, 0..0.99, from whichever of the stops comes first.
double expected_time_share(const master::Progress& progress, const StopSettings& stop);

/// Whether a limit of pieces, or one of coverage that filling reaches as a rule, leaves nothing to be improved.
bool ends_before_improving(const StopSettings& stop);

/// A run fills, perhaps several times (fit = "all"), then improves. Each of these phases is judged by its own pace in
/// this process, so that neither earlier attempts nor what came before an interruption count.
class TimeEstimate {
 public:
  TimeEstimate(const StopSettings& stop, const ImproveSettings& improve) : stop_(stop), improve_(improve) {}

  /// To be called with each progress in turn. Nothing while there is too little to judge by.
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
  double begin_share_ = 0;  // of it, that was over then
  std::size_t begin_pieces_ = 0;
  double piece_s_ = 0;  // while filling
};

}  // namespace tessera
