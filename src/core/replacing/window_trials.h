// The replacement trials of a window, one after another (replacement.h). A trial takes single pieces out, puts others
// into the hole and lets those around it make room. It is kept if the energy falls, or, by annealing, if it rises
// little.
#pragma once

#include "core/base/stop.h"
#include "core/base/task_pool.h"
#include "core/replacing/replacement.h"
#include "core/replacing/window_pieces.h"

namespace tessera {

/// Runs all trials of the window. `shapes` holds the shapes of all its pieces and of all that may come in. Calls
/// `check_stop` between trials, which may throw. The result has the same bits on every machine and with any number of
/// threads.
ReplacementOutcome replaced(const ReplacementWindow& window, const HoleShapes& shapes, const StopCheck& check_stop,
                            TaskPool& pool);

}  // namespace tessera
