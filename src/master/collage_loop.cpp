#include "master/collage_loop.h"

#include "core/stopwatch.h"
#include "master/collage.h"
#include "master/filling.h"
#include "master/ruin_and_recreate.h"


namespace tessera::master {
namespace {

/// One run: the state of the loop around the collage itself.
class Run {
 public:
  Run(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes, Observer& observer)
      : canvas_(canvas),
        settings_(settings),
        observer_(observer),
        context_(make_matching_context(settings, matcher.shapes().end)),
        collage_(canvas, settings, context_, shapes),
        filling_(collage_, context_, settings, matcher, statistics_) {}

  CollageResult finish() {
    fill();
    improve();
    statistics_.total_s = watch_.seconds();
    return {collage_.placements(), statistics_};
  }

 private:
  void fill() {
    while (!should_stop()) {
      if (!filling_.place_one()) {
        statistics_.stopped_by = "full";
        return;
      }
      tell();
    }
  }

  void improve() {
    if (statistics_.stopped_by != "full") return;
    const ImproveSettings& limits = settings_.improve;
    if (limits.trials == 0 && limits.seconds == 0) return;
    const Stopwatch watch;
    RuinAndRecreate ruin_and_recreate(collage_, filling_, settings_);
    while (!observer_.stop_requested() && (limits.trials == 0 || statistics_.trials < std::uint64_t(limits.trials)) &&
           (limits.seconds == 0 || watch.seconds() < limits.seconds)) {
      statistics_.trials_kept += ruin_and_recreate.try_once(std::uint32_t(statistics_.trials));
      ++statistics_.trials;
      tell();
    }
    statistics_.improve_s = watch.seconds();
  }

  void tell() {
    observer_.progressed({collage_.placements().size(), collage_.covered_px2() / canvas_.area_px2, watch_.seconds(),
                          collage_.open_samples(), statistics_.trials});
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
  Observer& observer_;
  MatchingContext context_;
  Collage collage_;
  RunStatistics statistics_;
  Filling filling_;
  Stopwatch watch_;
};

}  // namespace

CollageResult make_collage(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher,
                           ShapeSource& shapes, Observer& observer) {
  return Run(canvas, settings, matcher, shapes, observer).finish();
}

}  // namespace tessera::master
