// What a process keeps of the memory that it has freed.
#pragma once

#include <cstddef>

namespace tessera {

/// At most so much freed memory is kept by each process for what comes next, instead of being given back to the system
/// (main.cpp tells the allocator).
inline constexpr std::size_t kKeptFreed_bytes = std::size_t(64) << 20;

}  // namespace tessera
