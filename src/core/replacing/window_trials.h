// The replacement trials of a window, one after another (replacement.h): single pieces go out, others come into the
// hole, those round it make room, and it is kept where the energy becomes less, or by annealing little more.
#pragma once

#include "core/base/stop.h"
#include "core/base/task_pool.h"
#include "core/replacing/replacement.h"
#include "core/replacing/window_pieces.h"

namespace tessera {

/// `shapes` has those of all pieces of the window and of all that may come in. `check_stop` is called between trials and may
/// throw. The same bits on every machine, whoever helps with a trial's candidates.
ReplacementOutcome replaced(const ReplacementWindow& window, const HoleShapes& shapes, const StopCheck& check_stop,
                            TaskPool& pool);

}  // namespace tessera
