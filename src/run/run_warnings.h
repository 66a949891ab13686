// Writes the warnings of a run of tessera collage: before it begins, and about its result.
#pragma once

#include <vector>

#include "master/collage_loop.h"
#include "result/missing_shape.h"
#include "run/collage_input.h"
#include "run/collage_journal.h"
#include "run/collage_run.h"

namespace tessera {

/// Warns before the run begins. It asks no question, because users often edit a job and run it again on purpose.
void warn_of_problem(const CollageArguments& arguments, const CollageInput& input, CollageJournal& journal);

/// Warns of what the result lacks, and says what would let more pieces in. `missing`: missing_shapes() of the result.
void warn_of_result(const CollageArguments& arguments, const CollageInput& input, const master::CollageResult& result,
                    const std::vector<MissingShape>& missing, CollageJournal& journal);

}  // namespace tessera
