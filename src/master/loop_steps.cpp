#include "master/loop_steps.h"

namespace tessera::master {

LoopSteps::LoopSteps(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes,
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

bool LoopSteps::moves_given_pieces_only() const {
  const GivenPieces& given = regions_.given();
  return given.any_free() && end_.has_all_pieces(given.size());
}

bool LoopSteps::attempt_is_decided() const {
  return regions_.may_try_other_sizes() &&
         (collage().rules().shortage().pieces == 0 || end_.is_covered(collage().covered_px2()));
}

bool LoopSteps::end_at_limit_of_filling() {
  return end_.end_at_limit_of_filling(collage().placements().size(), collage().covered_px2());
}

StopReason LoopSteps::why_full() const {
  if (moves_given_pieces_only()) return StopReason::pieces;
  return collage().rules().may_go_on() ? StopReason::full : StopReason::used_up;
}

void LoopSteps::end_filling() {
  end_.region_is_full(why_full());
  if (settings_.improve.trials > 0 || settings_.improve.seconds > 0) {
    state_.phase = LoopPhase::trying;
  } else if (moves_given_pieces_only()) {
    end_.end_by(StopReason::pieces);
  }
}

ImprovingPhase LoopSteps::improving_phase() {
  end_.region_is_full(why_full());
  return ImprovingPhase({canvas_, settings_, regions_.current(), shapes_, replacer_, state_, end_, statistics_,
                         [this] { after_step(); }});
}

bool LoopSteps::begin_next_region() {
  if (end_.is_over() || !regions_.begin_next()) return false;
  state_.begin_region(collage().rules().limits().region);
  return true;
}

void LoopSteps::after_step() {
  observer_.progressed({collage().placements().size(), collage().covered_px2() / canvas_.area_px2, end_.run_s(),
                        state_.phase == LoopPhase::replacing, collage().open_samples(), state_.trials,
                        std::uint64_t(settings_.improve.trials), regions_.number()});
  if (keeper_ && keeper_->due()) keeper_->keep(checkpoint());
}

CheckpointState LoopSteps::checkpoint() {
  CheckpointState checkpoint;
  state_.run_s = end_.run_s();
  checkpoint.loop = state_;
  checkpoint.statistics = statistics_.of_run(state_);
  regions_.save(checkpoint);
  return checkpoint;
}

CollageResult LoopSteps::finish() {
  state_.run_s = end_.run_s();
  RunStatistics whole = statistics_.of_run(state_);
  whole.stopped_by = end_.reason();
  if (keeper_) keeper_->keep(checkpoint());
  return {collage().placements(), whole, end_.is_interrupted(), statistics_.of_this_call(end_.own_s()),
          end_.gave_up_question()};
}

}  // namespace tessera::master
