#include "master/collage_loop.h"

#include "core/stopwatch.h"
#include "master/collage.h"

namespace tessera::master {
namespace {

constexpr int kEmptyPasses = 2;  // over all samples, with new random dockings each time, before the canvas counts as full

/// One run: the state of the loop around the collage itself.
class Run {
 public:
  Run(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes, Observer& observer)
      : canvas_(canvas),
        settings_(settings),
        matcher_(matcher),
        observer_(observer),
        context_(make_matching_context(settings, matcher.shapes().end)),
        collage_(canvas, settings, context_, shapes) {
    statistics_.shapes = context_.library_shapes;
    for (const int level : context_.levels) pads_per_shape_ += kSmoothingLevels[level].samples;
    statistics_.pads_per_shape = double(pads_per_shape_);
  }

  CollageResult finish() {
    const CanvasField& field = collage_.free().field();
    matcher_.start_field(field.value.width(), field.value.height(), field.origin);
    while (!should_stop() && round()) {
    }
    statistics_.total_s = watch_.seconds();
    return {collage_.placements(), statistics_};
  }

 private:
  /// False when nothing fits any more.
  bool round() {
    match_stale();
    Candidate best;
    if (!choose(best)) return rematch();
    empty_passes_ = 0;
    place(best);
    return true;
  }

  void match_stale() {
    Stopwatch watch;
    const Window changed = collage_.take_changed_nodes();
    if (!changed.empty()) matcher_.update_field(read_patch(collage_.free().field().value, changed));
    const std::vector<TargetSample> samples = collage_.take_stale_samples();
    statistics_.merge_s += watch.lap();
    const MatchRound found = match(matcher_, samples, plan(), library_pads(), statistics_);
    watch.lap();
    collage_.add_candidates(samples, found);
    statistics_.objective_s += watch.lap();
  }

  MatchPlan plan() const {
    if (empty_passes_ > 0) return {0, std::uint32_t(kRematchTangentDockings)};
    const double share = settings_.match.top_percent / 100.0;
    return {std::uint64_t(share * double(library_pads())), std::uint32_t(settings_.match.tangent_dockings)};
  }

  std::uint64_t library_pads() const { return pads_per_shape_ * context_.library_shapes; }

  bool choose(Candidate& best) {
    Stopwatch watch;
    const bool found = collage_.choose(best);
    statistics_.objective_s += watch.lap();
    return found;
  }

  void place(const Candidate& best) {
    Stopwatch watch;
    collage_.place(best);
    statistics_.merge_s += watch.lap();
    ++statistics_.rounds;
    observer_.progressed({collage_.placements().size(), collage_.covered_px2() / canvas_.area_px2, watch_.seconds(),
                          collage_.open_samples()});
  }

  /// The pool is dry: all samples again, with other random dockings (design, method 9). PADs alone would give what they
  /// gave before.
  bool rematch() {
    if (empty_passes_ == kEmptyPasses || settings_.match.tangent_dockings == 0) {
      statistics_.stopped_by = "full";
      return false;
    }
    ++empty_passes_;
    collage_.mark_all_stale();
    return true;
  }

  bool should_stop() {
    const StopSettings& stop = settings_.stop;
    const char* reason = nullptr;
    if (stop.pieces > 0 && collage_.placements().size() >= std::size_t(stop.pieces)) reason = "pieces";
    if (collage_.covered_px2() >= double(stop.coverage) * canvas_.area_px2) reason = "coverage";
    if (stop.seconds > 0 && watch_.seconds() >= stop.seconds) reason = "seconds";
    if (observer_.stop_requested()) reason = "signal";
    if (reason) statistics_.stopped_by = reason;
    return reason != nullptr;
  }

  const Canvas& canvas_;
  const CollageSettings& settings_;
  Matcher& matcher_;
  Observer& observer_;
  MatchingContext context_;
  Collage collage_;
  RunStatistics statistics_;
  std::uint64_t pads_per_shape_ = 0;
  int empty_passes_ = 0;
  Stopwatch watch_;
};

}  // namespace

CollageResult make_collage(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher,
                           ShapeSource& shapes, Observer& observer) {
  return Run(canvas, settings, matcher, shapes, observer).finish();
}

}  // namespace tessera::master
