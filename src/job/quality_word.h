// The key `quality`: how much a job is improved, in a word. How many trials that takes goes by the canvas and the sizes
// of the pieces, so that the same word does for a postcard and for a poster.
#pragma once

#include "job/job_file.h"

namespace tessera {

/// Whether the sizes that the word goes by follow from canvas and library: with pieces.fit = "all", unless the word
/// asks for no trial at all.
bool quality_waits_for_sizes(const Job& job);

/// Puts what Job::quality says in the place of settings.improve's limits, when canvas and sizes are known in px; the
/// word is none then. Without a word the limits stay as they are. All sizes are `size_factor` times as large as the job
/// says.
void set_improving_by_quality(Job& job, double size_factor = 1);

}  // namespace tessera
