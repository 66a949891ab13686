#include "bench/benchmarks.h"
#include "core/base/error.h"
#include "text/number_text.h"

namespace tessera::bench {

void check(const SquareJob& job) {
  const auto [low, high] = job.scale_px;
  if (!(low >= 2 && low < high && high <= 5000)) {
    throw InputError("--scale-px: found " + short_number(low) + "," + short_number(high) +
                     "; allowed: MIN,MAX with 2 <= MIN < MAX <= 5000 px");
  }
  if (job.size_px < 16 || job.size_px > 10000) {
    throw InputError("--size: found " + std::to_string(job.size_px) + "; allowed: 16 to 10000 px");
  }
}

}  // namespace tessera::bench
