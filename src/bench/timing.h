// Measures repeated runs.
#pragma once

#include <algorithm>
#include <vector>

#include "core/base/stopwatch.h"

namespace tessera::bench {

/// The median time of `runs` calls of work(), in seconds, after one that does not count (caches, device compilers).
template <class Work>
double median_s(int runs, Work&& work) {
  work();
  std::vector<double> times_s;
  for (int run = 0; run < runs; ++run) {
    const Stopwatch watch;
    work();
    times_s.push_back(watch.seconds());
  }
  std::nth_element(times_s.begin(), times_s.begin() + runs / 2, times_s.end());
  return times_s[std::size_t(runs / 2)];
}

}  // namespace tessera::bench
