// How far each target sample looks for its pairs: as far as it takes to find as many as are docked (paper section 3.3,
// the best K % below beta), and hardly farther. Whoever asks the whole library decides, so that a part of it looks no
// farther than the whole must.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/matching/matcher.h"

namespace tessera {

/// The answer to a CountRequest: of each sample with bins, in order.
using CountPairs =
    std::function<std::vector<DistanceHistogram>(const std::vector<std::uint32_t>& bins, std::uint32_t segment_stride)>;

/// Of each of `samples` target samples the bins of its best pairs (bin_limit_for), at most `pairs` in a library of so
/// many `shapes`. Asks step by step: large libraries for some segments at first, which tell about how far it will be.
std::vector<std::uint32_t> pair_limits(std::size_t samples, std::uint64_t pairs, std::uint32_t shapes,
                                       const CountPairs& count);

/// The same, asking a matcher.
std::vector<std::uint32_t> pair_limits(Matcher& matcher, const std::vector<TargetSample>& samples, std::uint64_t pairs);

}  // namespace tessera
