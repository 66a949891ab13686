#include "bench/amdahl.h"

namespace tessera::bench {

AmdahlFit fit_amdahl(const std::vector<TimedRun>& runs) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const TimedRun& run : runs) {
    const double share = 1. / run.workers;
    n += 1;
    x += share;
    y += run.loop_s;
    xx += share * share;
    xy += share * run.loop_s;
  }
  const double spread = n * xx - x * x;
  if (spread <= 1e-12) return {0, x > 0 ? y / x : 0};
  const double parallel_s = (n * xy - x * y) / spread;
  return {(y - parallel_s * x) / n, parallel_s};
}

}  // namespace tessera::bench
