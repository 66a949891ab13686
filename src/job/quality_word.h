// The key `quality`: how much a job is improved, as a word. The number of trials follows from the canvas and the sizes
// of pieces, so that the same word suits a postcard and a poster.
#pragma once

#include "job/job_file.h"

namespace tessera {

/// Whether the word needs sizes that only canvas and library decide: with pieces.fit = "all", unless the word asks for
/// no trials.
bool quality_waits_for_sizes(const Job& job);

/// Sets the limits in settings.improve from Job::quality, which becomes none; canvas and sizes must be known in px.
/// Without a word the limits stay. All sizes are `size_factor` times as large as in the job.
void set_improving_by_quality(Job& job, double size_factor = 1);

}  // namespace tessera
