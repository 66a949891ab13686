// Shows the progress of the collage's loop to the user, and ends the loop at a signal or time limit.
#pragma once

#include <optional>

#include "core/base/stop.h"
#include "core/settings/settings.h"
#include "master/progress.h"
#include "run/progress/coverage_history.h"
#include "run/progress/time_estimate.h"
#include "run/progress/time_limit.h"
#include "terminal/progress_bar.h"

namespace tessera {

class CollageProgress : public master::Observer {
 public:
  /// `quiet`: shows nothing, but still obeys signals (comm/stop_signals.h) and the limit.
  CollageProgress(const CollageSettings& settings, bool quiet, const TimeLimit& limit = TimeLimit());

  void progressed(const master::Progress& progress) override;
  std::optional<StopReason> stop_requested() override;

  const CoverageHistory& history() const { return history_; }

 private:
  TimeEstimate estimate_;
  TimeLimit limit_;
  CoverageHistory history_;
  std::optional<ProgressBar> bar_;
};

/// "123 pieces, 45.6 % covered, 12.3 pieces/s"; later attempts (fit = "all") show their number instead of the rate.
std::string progress_note(const master::Progress& progress);

}  // namespace tessera
