#include "master/loop_run.h"

#include "master/improving_phase.h"

namespace tessera::master {

LoopRun::LoopRun(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes,
                 Observer& observer, const Checkpoints& checkpoints, Replacer* replacer)
    : canvas_(canvas),
      settings_(settings),
      shapes_(shapes),
      observer_(observer),
      keeper_(checkpoints.keeper),
      regions_(canvas, settings, matcher, shapes, statistics_.filling, [this] { end_.check_stop(); }),
      end_(canvas, settings, observer),
      own_replacer_(shapes, 1, [this] { end_.check_stop(); }),
      replacer_(replacer ? *replacer : own_replacer_) {
  if (const CheckpointState* from = checkpoints.from) {
    regions_.restore(*from);
    state_ = from->loop;
    end_.go_on_after(from->loop.run_s);
    statistics_.go_on_after(from->statistics);
  } else {
    regions_.begin_first();
  }
  statistics_.end_set_up();
}

bool LoopRun::moves_given_pieces_only() const {
  const GivenPieces& given = regions_.given();
  return given.any_free() && end_.has_all_pieces(given.size());
}

bool LoopRun::attempt_is_decided() const {
  return regions_.may_try_other_sizes() &&
         (collage().open_shapes().shortage().pieces == 0 || end_.is_covered(collage().covered_px2()));
}

bool LoopRun::end_at_limit_of_filling() {
  return end_.end_at_limit_of_filling(collage().placements().size(), collage().covered_px2());
}

StopReason LoopRun::why_full() const {
  if (moves_given_pieces_only()) return StopReason::pieces;
  return collage().open_shapes().may_go_on() ? StopReason::full : StopReason::used_up;
}

void LoopRun::end_filling() {
  end_.region_is_full(why_full());
  if (settings_.improve.trials > 0 || settings_.improve.seconds > 0) {
    state_.phase = LoopPhase::trying;
  } else if (moves_given_pieces_only()) {
    end_.end_by(StopReason::pieces);
  }
}

void LoopRun::improve() {
  end_.region_is_full(why_full());
  ImprovingPhase phase({canvas_, settings_, regions_.current(), shapes_, replacer_, state_, end_, statistics_,
                        [this] { after_step(); }});
  phase.run();
}

bool LoopRun::begin_next_region() {
  if (end_.is_over() || !regions_.begin_next()) return false;
  state_.begin_region(collage().open_shapes().limits().region);
  return true;
}

void LoopRun::after_step() {
  observer_.progressed({.pieces = collage().placements().size(),
                        .coverage = collage().covered_px2() / canvas_.area_px2,
                        .seconds = end_.run_s(),
                        .exchanging = state_.phase == LoopPhase::replacing,
                        .open_samples = collage().open_samples(),
                        .trials = state_.trials,
                        .most_trials = std::uint64_t(settings_.improve.trials),
                        .attempt = regions_.attempt_number()});
  if (keeper_ && keeper_->due(state_.phase)) keeper_->keep(checkpoint());
}

CheckpointState LoopRun::checkpoint() {
  CheckpointState checkpoint;
  state_.run_s = end_.run_s();
  checkpoint.loop = state_;
  checkpoint.statistics = statistics_.of_run(state_);
  regions_.save(checkpoint);
  return checkpoint;
}

CollageResult LoopRun::finish() {
  state_.run_s = end_.run_s();
  RunStatistics whole = statistics_.of_run(state_);
  whole.stopped_by = end_.reason();
  if (keeper_) keeper_->keep(checkpoint());
  return {collage().placements(), whole, end_.is_interrupted(), statistics_.of_this_call(end_.own_s()),
          end_.matcher_interrupted()};
}

}  // namespace tessera::master
