// Processor time: other work on a busy machine does not lengthen it.
#pragma once

#include <ctime>

namespace tessera {

/// The processor time of this process, all threads together, seconds.
inline double processor_time_s() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// The processor time of the calling thread, seconds.
inline double thread_processor_time_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

}  // namespace tessera
