// The memory of this process, as Linux counts it.
#pragma once

#include <cstdint>

namespace tessera::bench {

/// Starts a new measurement of the peak of resident memory.
void reset_peak_memory();

/// The peak of resident memory; 0 where the system does not report it.
std::uint64_t peak_memory_bytes();

}  // namespace tessera::bench
