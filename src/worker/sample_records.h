// The target samples of a request as the kernels read them.
#pragma once

#include <vector>

#include "core/target_curve.h"
#include "records.h"

namespace tessera::worker {

/// `bin_limit`: one for each sample, or empty (0 for all).
std::vector<SampleRecord> make_sample_records(const std::vector<TargetSample>& samples,
                                              const std::vector<std::uint32_t>& bin_limit, int pad_levels);

/// Whether both give the same pairs, and the same draws: all but the bin limits.
bool same_samples(const std::vector<SampleRecord>& a, const std::vector<SampleRecord>& b);

}  // namespace tessera::worker
