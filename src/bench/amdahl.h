// Amdahl's law: the part of the time that more workers cannot shorten.
#pragma once

#include <vector>

namespace tessera::bench {

struct TimedRun {
  int workers = 1;
  double loop_s = 0;
};

/// The fit loop_s = serial_s + parallel_s / workers.
struct AmdahlFit {
  double serial_s = 0;
  double parallel_s = 0;

  double serial_share() const { return serial_s / (serial_s + parallel_s); }
  double loop_s(int workers) const { return serial_s + parallel_s / workers; }
};

/// Fits by least squares. With a single number of workers all of the time counts as parallel. Scattered times may give
/// a negative serial part.
AmdahlFit fit_amdahl(const std::vector<TimedRun>& runs);

}  // namespace tessera::bench
