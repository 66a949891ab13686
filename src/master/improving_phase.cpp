#include "master/improving_phase.h"

#include <utility>

#include "core/base/stop.h"
#include "master/replacing.h"

namespace tessera::master {
namespace {

/// Trials before replacements begin; the first trial relaxes all pieces.
constexpr std::uint32_t kTrialsBeforeReplacing = 1;

}  // namespace

ImprovingPhase::ImprovingPhase(Parts parts)
    : parts_(std::move(parts)),
      state_(parts_.state),
      collage_(parts_.region.collage),
      budget_(parts_.canvas, parts_.settings),
      first_trial_(std::uint32_t(budget_.first_trial(state_.region))),
      area_px2_(budget_.area_px2(state_.region)),
      earlier_s_(state_.improve_s),
      improving_(collage_, parts_.region.filling, parts_.region.sized, area_px2_, parts_.shapes) {
  parts_.region.filling.count_into(parts_.statistics.improving);
}

void ImprovingPhase::run() {
  try {
    while (goes_on()) step();
  } catch (const Interrupted&) {
    take_time();
    throw;
  }
}

/// Whether there is another step. Replaced pieces are always relaxed at the end, also when a limit is reached or after an
/// interruption.
bool ImprovingPhase::goes_on() { return state_.phase == LoopPhase::replacing || (may_improve() && !reached_limit()); }

void ImprovingPhase::step() {
  parts_.end.check_stop();
  if (state_.phase == LoopPhase::trying && state_.trials == first_trial_ + kTrialsBeforeReplacing) begin_replacing();
  if (state_.phase == LoopPhase::trying) return try_once();
  const std::uint64_t all = replacements();
  if (state_.replaced < all) {
    replace(all);
  } else {
    relax_replaced_pieces();
  }
}

void ImprovingPhase::try_once() {
  count(improving_.try_once(
      std::uint32_t(state_.trials), [this] { parts_.end.check_stop(); }, first_trial_));
}

/// Begins the replacement phase, if there is time to replace each piece once at least.
void ImprovingPhase::begin_replacing() {
  state_.replaced = 0;
  if (pays_to_replace(parts_.region.sized) && replacements() >= free_pieces()) state_.replace_in(collage_.placements());
}

/// The number of replacements of the phase. When trials or time are used up, the number of those already done.
std::uint64_t ImprovingPhase::replacements() {
  if (state_.phase == LoopPhase::replacing && (!may_improve() || reached_limit())) return state_.replaced;
  return budget_.replacements(state_.region, free_pieces(), {state_.replaced, state_.improve_s, parts_.end.run_s()});
}

void ImprovingPhase::replace(std::uint64_t all) {
  const OpenShapes& open_shapes = collage_.open_shapes();
  Replacing replacing(
      collage_.free(), open_shapes.stances(), parts_.region.sized, area_px2_, parts_.shapes,
      [&](const Placement& p) { return open_shapes.poses_of(p); }, parts_.replacer);
  ReplacementProgress progress{state_.replaced, all};
  const Stopwatch asked;
  state_.replace_in(replacing.batch(state_.moving, open_shapes.given(), progress, [this] { parts_.end.check_stop(); }));
  parts_.statistics.improving.replace_s += asked.seconds();
  state_.trials += progress.done / kReplacementsPerTrial - state_.replaced / kReplacementsPerTrial;
  state_.replaced = progress.done;
  take_time();
  parts_.after_step();
}

/// Relaxes the replaced pieces until they are clear of each other, and keeps them or puts the former pieces back.
void ImprovingPhase::relax_replaced_pieces() {
  const Trial trial = improving_.relax_replaced_pieces(state_.moving, std::uint32_t(state_.trials),
                                                       [this] { parts_.end.check_stop(); });
  state_.replace_in({});
  count(trial);
}

void ImprovingPhase::count(Trial trial) {
  parts_.statistics.filling.trials_kept += trial == Trial::kept;
  ++state_.trials;
  take_time();
  parts_.after_step();
}

bool ImprovingPhase::may_improve() const { return budget_.may_go_on(state_.region, state_.trials, state_.improve_s); }

bool ImprovingPhase::reached_limit() { return parts_.end.reached_limit(collage_.covered_px2()); }

std::size_t ImprovingPhase::free_pieces() const {
  return collage_.placements().size() - collage_.open_shapes().given();
}

}  // namespace tessera::master
