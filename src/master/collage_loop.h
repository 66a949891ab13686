// The loop of the paper (section 4, Fig. 15): match, choose, merge, until nothing fits.
#pragma once

#include "core/base/run_statistics.h"
#include "core/collage/checkpoint_state.h"
#include "core/collage/placement.h"
#include "core/field/canvas.h"
#include "core/matching/matcher.h"
#include "core/replacing/replacer.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"
#include "master/checkpoint_keeper.h"
#include "master/progress.h"

namespace tessera::master {

struct CollageResult {
  std::vector<Placement> placements;
  RunStatistics statistics;
  bool unfinished = false;           // the observer asked to stop or the matcher threw Interrupted, before all was done
  RunStatistics own_work;            // times, rounds and target samples of this call alone, trials included
  bool matcher_interrupted = false;  // the matcher threw Interrupted: it must not be asked again
};

/// The state from which the loop starts, and the keeper of its checkpoints.
struct Checkpoints {
  const CheckpointState* from = nullptr;  // null: starts with an empty canvas
  // Null: keeps nothing. Otherwise the loop ends with a checkpoint, finished or not.
  CheckpointKeeper* keeper = nullptr;
};

/// Runs the loop. `matcher` covers the whole library, and so does `replacer`, which runs replacement trials (null: this
/// thread runs them). Where the matcher throws Interrupted, the loop ends within a round, as if the observer had asked it
/// to stop, and keeps the state before the question. A run that goes on `from` this checkpoint, with the same canvas,
/// settings and library, places the same pieces as a run without the interruption. Throws InputError where `from` belongs
/// to another canvas or library.
CollageResult make_collage(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes,
                           Observer& observer, const Checkpoints& checkpoints = {}, Replacer* replacer = nullptr);

}  // namespace tessera::master
