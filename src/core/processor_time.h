// Processor time of this process, all threads together: what a busy machine's other work does not lengthen.
#pragma once

#include <ctime>

namespace tessera {

inline double processor_time_s() { return double(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace tessera
