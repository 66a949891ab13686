// The warnings of a collage's run: before it begins, and of what it made.
#pragma once

#include <vector>

#include "master/collage_loop.h"
#include "result/missing_shape.h"
#include "run/collage_input.h"
#include "run/collage_journal.h"
#include "run/collage_run.h"

namespace tessera {

/// Before it is too late, but no question: whoever edits a job and runs it again wants just that.
void warn_of_problem(const CollageArguments& arguments, const CollageInput& input, CollageJournal& journal);

/// What the result lacks, and what would let more in. `missing`: missing_shapes() of the result.
void warn_of_result(const CollageArguments& arguments, const CollageInput& input, const master::CollageResult& result,
                    const std::vector<MissingShape>& missing, CollageJournal& journal);

}  // namespace tessera
