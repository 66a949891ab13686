#include "master/collage_loop.h"

#include <string>

#include "core/base/error.h"
#include "core/base/interrupted.h"
#include "core/base/processor_time.h"
#include "core/base/stopwatch.h"
#include "master/collage.h"
#include "master/filling.h"
#include "master/ruin_and_recreate.h"

namespace tessera::master {
namespace {

/// One run: the state of the loop around the collage itself.
class Run {
 public:
  Run(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes, Observer& observer,
      const Checkpoints& checkpoints)
      : canvas_(canvas),
        settings_(settings),
        observer_(observer),
        keeper_(checkpoints.keeper),
        context_(make_matching_context(settings, matcher.shapes().end)),
        collage_(canvas, settings, context_, shapes),
        filling_(collage_, context_, settings, matcher, statistics_),
        setup_processor_s_(processor_time_s() - processor_before_s_) {
    if (checkpoints.from) restore(*checkpoints.from);
  }

  CollageResult finish() {
    try {
      if (!improving_) fill();
      if (improving_) improve();
    } catch (const Interrupted& interrupted) {
      stop_unfinished(interrupted.reason);
      gave_up_question_ = true;
    }
    statistics_.total_s = seconds();
    if (keeper_) keeper_->keep(state());
    return {collage_.placements(), statistics_, unfinished_, own_work(), gave_up_question_};
  }

 private:
  void restore(const CheckpointState& from) {
    collage_.restore(from);
    statistics_ = from.statistics;
    earlier_ = from.statistics;
    improving_ = from.improving;
    if (!filling_.restore_empty_passes(from.empty_passes)) {
      throw InputError(from.name + ": not a checkpoint of this job: " + std::to_string(from.empty_passes) +
                       " passes without a piece; --restart removes it and starts again");
    }
  }

  CheckpointState state() const {
    CheckpointState state;
    state.improving = improving_;
    state.empty_passes = improving_ ? 0 : filling_.empty_passes();
    state.statistics = statistics_;
    state.statistics.total_s = seconds();
    state.statistics.stopped_by.clear();
    collage_.save(state);
    return state;
  }

  void fill() {
    while (!should_stop()) {
      if (!filling_.place_one()) {
        statistics_.stopped_by = "full";
        improving_ = settings_.improve.trials > 0 || settings_.improve.seconds > 0;
        return;
      }
      after_step();
    }
  }

  void improve() {
    statistics_.stopped_by = "full";
    filling_.count_into(trial_work_);
    const double earlier_s = statistics_.improve_s;
    const Stopwatch watch;
    RuinAndRecreate ruin_and_recreate(collage_, filling_, settings_);
    while (may_improve() && !reached_limit() && !interrupted()) {
      const Trial trial = ruin_and_recreate.try_once(std::uint32_t(statistics_.trials),
                                                     [this] { return observer_.stop_requested() != nullptr; });
      statistics_.improve_s = earlier_s + watch.seconds();
      if (trial == Trial::interrupted) continue;
      statistics_.trials_kept += trial == Trial::kept;
      ++statistics_.trials;
      after_step();
    }
  }

  bool may_improve() const {
    const ImproveSettings& limits = settings_.improve;
    return (limits.trials == 0 || statistics_.trials < std::uint64_t(limits.trials)) &&
           (limits.seconds == 0 || statistics_.improve_s < limits.seconds);
  }

  void after_step() {
    observer_.progressed({collage_.placements().size(), collage_.covered_px2() / canvas_.area_px2, seconds(),
                          collage_.open_samples(), statistics_.trials, std::uint64_t(settings_.improve.trials)});
    if (keeper_ && keeper_->due()) keeper_->keep(state());
  }

  bool should_stop() {
    const StopSettings& stop = settings_.stop;
    if (stop.pieces > 0 && collage_.placements().size() >= std::size_t(stop.pieces)) {
      statistics_.stopped_by = "pieces";
      return true;
    }
    return reached_limit() || interrupted();
  }

  /// That ends filling and improving alike.
  bool reached_limit() {
    const StopSettings& stop = settings_.stop;
    const bool covered = collage_.covered_px2() >= double(stop.coverage) * canvas_.area_px2;
    const bool late = stop.seconds > 0 && seconds() >= stop.seconds;
    if (covered || late) statistics_.stopped_by = late ? "seconds" : "coverage";
    return covered || late;
  }

  bool interrupted() {
    const char* reason = observer_.stop_requested();
    if (!reason) return false;
    stop_unfinished(reason);
    return true;
  }

  void stop_unfinished(const char* reason) {
    statistics_.stopped_by = reason;
    unfinished_ = true;
  }

  RunStatistics own_work() const {
    RunStatistics work = trial_work_;
    work.setup_processor_s = setup_processor_s_;
    work.total_s = watch_.seconds();
    work.prune_s += statistics_.prune_s - earlier_.prune_s;
    work.dock_s += statistics_.dock_s - earlier_.dock_s;
    work.ahead_s += statistics_.ahead_s - earlier_.ahead_s;
    work.objective_s += statistics_.objective_s - earlier_.objective_s;
    work.merge_s += statistics_.merge_s - earlier_.merge_s;
    work.rounds += statistics_.rounds - earlier_.rounds;
    work.target_samples += statistics_.target_samples - earlier_.target_samples;
    return work;
  }

  /// Of the run as a whole, what came before an interruption included.
  double seconds() const { return earlier_.total_s + watch_.seconds(); }

  const double processor_before_s_ = processor_time_s();
  const Canvas& canvas_;
  const CollageSettings& settings_;
  Observer& observer_;
  CheckpointKeeper* keeper_;
  MatchingContext context_;
  Collage collage_;
  RunStatistics statistics_;  // of the greedy part, with the number of trials
  RunStatistics trial_work_;
  Filling filling_;
  const double setup_processor_s_;
  Stopwatch watch_;
  RunStatistics earlier_;  // before an interruption
  bool improving_ = false;
  bool unfinished_ = false;
  bool gave_up_question_ = false;
};

}  // namespace

CollageResult make_collage(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher,
                           ShapeSource& shapes, Observer& observer, const Checkpoints& checkpoints) {
  return Run(canvas, settings, matcher, shapes, observer, checkpoints).finish();
}

}  // namespace tessera::master
