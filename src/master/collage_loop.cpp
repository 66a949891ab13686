// The outline of the algorithm. Filling places one piece after the other (Filling::place_one).
#include "master/collage_loop.h"

#include "core/base/stop.h"
#include "master/loop_run.h"

namespace tessera::master {
namespace {

/// Places piece after piece until none fits or a limit of the job is reached (paper, section 4 and Fig. 15). With
/// fit = "all" it begins again at other sizes, until it knows at which sizes every wanted piece finds a place.
void fill_region(LoopRun& run) {
  if (run.moves_given_pieces_only()) return run.end_filling();
  for (;;) {
    if (run.attempt_is_decided() && run.regions().begin_other_sizes()) continue;
    if (run.end_at_limit_of_filling()) return run.regions().keep_best();
    run.end().check_stop();
    if (run.place_one()) {
      run.after_step();
    } else if (!run.regions().begin_other_sizes()) {
      return run.end_filling();
    }
  }
}

/// Goes beyond the greedy paper: trials replace pieces or move all of them, and lower the loss.
void improve_region(LoopRun& run) { run.improve(); }

}  // namespace

CollageResult make_collage(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes,
                           Observer& observer, const Checkpoints& checkpoints, Replacer* replacer) {
  LoopRun run(canvas, settings, matcher, shapes, observer, checkpoints, replacer);
  try {
    do {  // a checkpoint may lie in either phase
      if (run.is_filling()) fill_region(run);
      if (!run.is_filling()) improve_region(run);
    } while (run.begin_next_region());
  } catch (const Interrupted& stopped) {
    run.end().interrupt(stopped.reason);
  }
  return run.finish();
}

}  // namespace tessera::master
