// Amdahl's law: what more workers cannot shorten.
#pragma once

#include <vector>

namespace tessera::bench {

struct TimedRun {
  int workers = 1;
  double loop_s = 0;
};

/// loop_s = serial_s + parallel_s / workers.
struct AmdahlFit {
  double serial_s = 0;
  double parallel_s = 0;

  double serial_share() const { return serial_s / (serial_s + parallel_s); }
  double loop_s(int workers) const { return serial_s + parallel_s / workers; }
};

/// Fits by least squares; all of the time counts as parallel where there is only one number of workers. Times that
/// scatter may give a negative serial part.
AmdahlFit fit_amdahl(const std::vector<TimedRun>& runs);

}  // namespace tessera::bench
