// Memory of this process, as Linux counts it.
#pragma once

#include <cstdint>

namespace tessera::bench {

/// Peak resident memory counts from here on.
void reset_peak_memory();

/// The peak of resident memory; 0 where the system does not tell.
std::uint64_t peak_memory_bytes();

}  // namespace tessera::bench
