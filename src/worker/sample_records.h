// The target samples of a request as the kernels read them.
#pragma once

#include <vector>

#include "core/field/target_sample.h"
#include "records.h"

namespace tessera::worker {

/// Makes the records without reach and without wishes for colours.
std::vector<SampleRecord> make_sample_records(const std::vector<TargetSample>& samples, const MatchRecord& match,
                                              int pad_levels);

/// Limits the record to pairs nearer than this, in steps of the PAD distance.
void set_reach(SampleRecord& record, std::uint32_t reach_steps);

/// Whether both lists give the same pairs within the same reach, and the same random draws.
bool same_samples(const std::vector<SampleRecord>& a, const std::vector<SampleRecord>& b);

}  // namespace tessera::worker
