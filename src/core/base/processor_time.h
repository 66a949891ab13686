// Processor time: what a busy machine's other work does not lengthen.
#pragma once

#include <ctime>

namespace tessera {

/// The processor time of this process, all threads together.
inline double processor_time_s() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// The processor time of the calling thread.
inline double thread_processor_time_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

}  // namespace tessera
