// The end of tessera collage: makes the result of the loop's placements.
#pragma once

#include <string>
#include <vector>

#include "core/ranks/rank_statistics.h"
#include "master/collage_loop.h"
#include "result/folder/run_record.h"
#include "result/missing_shape.h"
#include "run/collage_checkpoints.h"
#include "run/collage_input.h"

namespace tessera {

/// Whether the run was ended before its first piece while the folder holds a finished collage, which an empty result must
/// not replace.
bool leaves_older_result(const CollageInput& input, const master::CollageResult& result);

/// Writes all files but the pictures, then removes the checkpoints of a finished run; so the folder holds the run's state
/// at every moment. Returns the text of the card. Throws EnvironmentError, also where an unfinished run has no checkpoint.
std::string publish(const CollageInput& input, const master::CollageResult& result,
                    const std::vector<MissingShape>& missing, const RankStatistics& ranks, const RunRecord& record,
                    const CollageCheckpoints& checkpoints);

}  // namespace tessera
