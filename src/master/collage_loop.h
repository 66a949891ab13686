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
  bool unfinished = false;  // the observer asked to stop, or the matcher threw Interrupted, and there was more to do
  RunStatistics own_work;   // of this call alone, trials included: times, rounds and target samples
  bool gave_up_question = false;  // the matcher threw Interrupted: it must not be asked again
};

/// Where the loop starts, and where its state is kept.
struct Checkpoints {
  const CheckpointState* from = nullptr;  // null: from an empty canvas
  CheckpointKeeper* keeper = nullptr;     // null: nowhere; the loop ends with a checkpoint, finished or not
};

/// `matcher` covers the whole library. Where it throws Interrupted, the loop ends within a round as if the observer had
/// asked it to stop, and the state that is kept is that before the question. A loop that was interrupted and goes on
/// `from` its checkpoint, with the same canvas, settings and library, places what it would have placed without the
/// interruption. `replacer`, of the same library: who runs replacement trials; null: this thread. Throws InputError where `from` belongs to another canvas or library.
CollageResult make_collage(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes,
                           Observer& observer, const Checkpoints& checkpoints = {}, Replacer* replacer = nullptr);

}  // namespace tessera::master
