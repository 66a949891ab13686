#include "bench/baselines/full_rematch.h"

#include "core/base/stopwatch.h"
#include "master/collage.h"

namespace tessera::bench {
namespace {

constexpr int kEmptyRounds = 2;  // each with different random dockings

}  // namespace

master::CollageResult make_collage_afresh(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher,
                                          ShapeSource& shapes) {
  const Stopwatch watch;
  const MatchingContext context = make_matching_context(settings, matcher.shapes().end);
  const std::uint64_t pads = pads_per_shape(context) * context.library_shapes;
  const MatchPlan plan = match_plan(settings.match, pads);
  master::Collage collage(canvas, settings, context, shapes);
  const CanvasField& field = collage.free().field();
  matcher.start_field(field.value.width(), field.value.height(), field.origin);
  const auto send_field = [&] { matcher.update_field({read_patch(field.value, field.value.bounds())}); };
  send_field();
  RunStatistics statistics;
  for (int empty = 0; empty < kEmptyRounds;) {
    collage.schedule().mark(collage.free().field().value.bounds());
    const std::vector<TargetSample> samples = collage.schedule().take();
    collage.add_candidates(samples, match(matcher, samples, plan, pads, statistics));
    Candidate best;
    if (collage.choose(best)) {
      collage.place(best);
      send_field();
      collage.merge_batch();
      matcher.post_measure(collage.touched());
      collage.end_batch(matcher.take_measure());
      empty = 0;
    } else {
      ++empty;
    }
  }
  statistics.total_s = watch.seconds();
  return {collage.placements(), statistics, false, statistics};
}

}  // namespace tessera::bench
