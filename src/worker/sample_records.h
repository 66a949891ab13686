// The target samples of a request as the kernels read them.
#pragma once

#include <vector>

#include "core/field/target_sample.h"
#include "records.h"

namespace tessera::worker {

/// Without reach, and without colours that are wished for.
std::vector<SampleRecord> make_sample_records(const std::vector<TargetSample>& samples, const MatchRecord& match,
                                              int pad_levels);

/// From here on the record is of the pairs nearer than this.
void set_reach(SampleRecord& record, std::uint32_t reach_steps);

/// Whether both give the same pairs within the same reach, and the same draws.
bool same_samples(const std::vector<SampleRecord>& a, const std::vector<SampleRecord>& b);

}  // namespace tessera::worker
