// Names of target samples.
#pragma once

#include <cstdint>

namespace tessera {

/// A target sample, by the number of the grid edge that it lies on (GridEdge::number). The sample keeps this name while
/// the free region's boundary crosses that edge. Its index in a request or a list is a plain number instead.
enum class SampleId : std::uint32_t {};

constexpr std::uint32_t edge_number(SampleId sample) { return std::uint32_t(sample); }

}  // namespace tessera
