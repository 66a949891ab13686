// Limits of the PAD distance up to which each target sample searches its pairs. They are just large enough to find as
// many pairs as are docked (paper section 3.3, the best K % below beta). The caller that asks the whole library decides
// the limits, so that no part of the library is searched farther than the whole needs.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/matching/matcher.h"

namespace tessera {

/// Answers a CountRequest: one histogram for each sample whose number of bins is not 0, in order.
using CountPairs =
    std::function<std::vector<DistanceHistogram>(const std::vector<std::uint32_t>& bins, std::uint32_t segment_stride)>;

/// Returns for each of `samples` target samples the bins of its best pairs (bin_limit_for), at most `pairs`, in a
/// library of `shapes` shapes. Counts step by step. In a large library it first counts a few segments, to estimate the
/// limits.
std::vector<std::uint32_t> pair_limits(std::size_t samples, std::uint64_t pairs, std::uint32_t shapes,
                                       const CountPairs& count);

/// Computes the limits with the counts of a matcher.
std::vector<std::uint32_t> pair_limits(Matcher& matcher, const std::vector<TargetSample>& samples, std::uint64_t pairs);

}  // namespace tessera
