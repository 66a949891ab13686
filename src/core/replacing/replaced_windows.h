// The replacement trials of many windows on the threads of a pool.
#pragma once

#include <vector>

#include "core/base/stop.h"
#include "core/base/task_pool.h"
#include "core/replacing/replacement.h"
#include "core/replacing/window_pieces.h"

namespace tessera {

/// The outcomes of the windows, in their order: the same on any number of threads. `shapes` has those of all windows. As
/// many threads work as the pool is broad, while this one calls `check_stop` again and again; where the system gives no
/// thread, this one works without calling it. Throws what `check_stop` or a window threw, once all threads have ended.
std::vector<ReplacementOutcome> replaced_windows(const std::vector<ReplacementWindow>& windows,
                                                 const HoleShapes& shapes, TaskPool& pool, const StopCheck& check_stop);

}  // namespace tessera
