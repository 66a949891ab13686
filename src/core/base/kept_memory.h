// The amount of freed memory that a process keeps.
#pragma once

#include <cstddef>

namespace tessera {

/// Each process keeps at most this amount of freed memory for later use, instead of returning it to the system
/// (main.cpp tells the allocator).
inline constexpr std::size_t kKeptFreed_bytes = 64'000'000;

}  // namespace tessera
