// The target samples of a request as the kernels read them.
#pragma once

#include <vector>

#include "core/field/target_sample.h"
#include "records.h"

namespace tessera::worker {

/// `bin_reach`: per sample, only pairs in the bins below this count.
std::vector<SampleRecord> make_sample_records(const std::vector<TargetSample>& samples,
                                              const std::vector<std::uint32_t>& bin_reach, const MatchRecord& match,
                                              int pad_levels);

/// Whether both give the same pairs within the same reach, and the same draws.
bool same_samples(const std::vector<SampleRecord>& a, const std::vector<SampleRecord>& b);

}  // namespace tessera::worker
