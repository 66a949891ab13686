// Room for lists that kernels fill. Kernels count all records that they would add; where there are more than fit, the
// question is asked again with more room.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/base/error.h"

namespace tessera::worker {

/// The kernels' counters stop here (kernels/portable_math.cl).
inline constexpr std::uint32_t kMostCounted = std::uint32_t(1) << 31;

/// The number of records that fit into `bytes`, but one at least.
inline std::uint32_t room_in(std::size_t bytes, std::size_t record_bytes) {
  return std::uint32_t(std::max<std::size_t>(1, bytes / record_bytes));
}

/// Room for `needed` records: never less than `room`, otherwise a power of two.
inline std::uint32_t grown_room(std::uint32_t room, std::uint32_t needed) {
  if (needed <= room) return room;
  if (needed >= kMostCounted) {
    throw EnvironmentError(
        "more pairs or dockings than a device can count: lower match.beta, match.top_percent or "
        "match.most_pairs, or give the job more ranks");
  }
  return std::bit_ceil(needed);
}

}  // namespace tessera::worker
