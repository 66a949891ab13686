#include "bench/concepts/docked_round.h"

#include "core/matching/pair_limits.h"

namespace tessera::bench::concepts {

DockedRound docked_round(CollageStage& stage, const TracedTarget& target) {
  DockedRound round;
  round.samples = target.samples();
  const MatchPlan plan =
      match_plan(stage.settings().match, pads_per_shape(stage.context()) * stage.context().library_shapes);
  Matcher& matcher = stage.matcher();
  const DockRequest request{round.samples, pair_limits(matcher, round.samples, plan.pairs_per_sample),
                            plan.tangent_dockings, false};
  matcher.post_dock(request);
  round.docked = matcher.take_dock().dockings;
  matcher.post_refine(round.docked);
  round.refined = matcher.take_refine();
  return round;
}

}  // namespace tessera::bench::concepts
