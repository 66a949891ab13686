// What a process keeps of the memory that it has freed.
#pragma once

#include <cstddef>

namespace tessera {

/// At most so much freed memory is kept by each process for what comes next, instead of being given back to the system
/// (main.cpp tells the allocator).
inline constexpr std::size_t kKeptFreed_bytes = 64'000'000;

}  // namespace tessera
