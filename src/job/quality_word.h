// The key `quality`: how much a job is improved, in a word. How many trials that takes goes by the canvas and the sizes
// of the pieces, so that the same word does for a postcard and for a poster.
#pragma once

#include "job/job_file.h"

namespace tessera {

/// Puts what Job::quality says in the place of settings.improve's limits, when canvas and sizes are known in px.
/// Without a word they stay as they are.
void set_improving_by_quality(Job& job);

}  // namespace tessera
