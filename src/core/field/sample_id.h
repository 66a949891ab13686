// How target samples are named.
#pragma once

#include <cstdint>

namespace tessera {

/// A target sample by the number of the grid edge that it lies on (GridEdge::number): it keeps its name for as long as
/// the free region's boundary crosses that edge. It is not the sample's place in a request or a list, which is a plain
/// number.
enum class SampleId : std::uint32_t {};

constexpr std::uint32_t edge_number(SampleId sample) { return std::uint32_t(sample); }

}  // namespace tessera
