// Runs the replacement trials of many windows on the threads of a pool.
#pragma once

#include <vector>

#include "core/base/stop.h"
#include "core/base/task_pool.h"
#include "core/replacing/replacement.h"
#include "core/replacing/window_pieces.h"

namespace tessera {

/// The outcomes of the windows, in their order; the number of threads makes no difference. `shapes` holds the shapes of
/// all windows. The threads of the pool work while the calling thread calls `check_stop` repeatedly. If the system
/// gives no extra thread, the calling thread works and does not call it. Throws the exception of `check_stop` or of a
/// window, after all threads have ended.
std::vector<ReplacementOutcome> replaced_windows(const std::vector<ReplacementWindow>& windows,
                                                 const HoleShapes& shapes, TaskPool& pool, const StopCheck& check_stop);

}  // namespace tessera
