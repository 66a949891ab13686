#include "master/collage_loop.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/base/count_text.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/processor_time.h"
#include "core/base/stop.h"
#include "core/base/stopwatch.h"
#include "core/matching/sized_settings.h"
#include "core/replacing/own_replacer.h"
#include "core/settings/tuning.h"
#include "master/collage.h"
#include "master/filling.h"
#include "master/improving.h"
#include "master/improving_budget.h"
#include "master/replacing.h"
#include "master/size_attempts.h"
#include "master/standing_pieces.h"

namespace tessera::master {
namespace {

/// The first trial lets all pieces move.
constexpr std::uint32_t kTrialsBeforeReplacing = 1;

Canvas region_of(const Canvas& canvas, std::uint32_t region) {
  return {.width_px = canvas.width_px,
          .height_px = canvas.height_px,
          .distance = canvas.regions.empty() ? canvas.distance : canvas.regions[region].distance,
          .area_px2 = canvas.area_px2,
          .keep_out = canvas.keep_out,
          .period = canvas.period};
}

/// The observer asked to stop while no question was under way.
struct StoppedBetween : Interrupted {};

/// A region of the canvas, while it is filled, at the sizes of one attempt.
struct Part {
  Part(const Canvas& region, const CollageSettings& settings, const MatchingContext& context, float size_factor,
       Matcher& matcher, ShapeSource& shapes, RunStatistics& statistics, StopCheck check_stop)
      : sized(with_sizes_times(double(size_factor), settings)),
        collage(region, sized, context, shapes, size_factor),
        filling(collage, context, sized, matcher, statistics, std::move(check_stop)) {}

  CollageSettings sized;
  Collage collage;
  Filling filling;
};

/// Seconds of improving, what came before an interruption included.
struct ImproveClock {
  double earlier_s = 0;
  Stopwatch watch;

  double seconds() const { return earlier_s + watch.seconds(); }
};

/// One run: the state of the loop around the collage itself.
class Run {
 public:
  Run(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes, Observer& observer,
      const Checkpoints& checkpoints, Replacer* replacer)
      : canvas_(canvas),
        settings_(settings),
        matcher_(matcher),
        shapes_(shapes),
        observer_(observer),
        keeper_(checkpoints.keeper),
        context_(make_matching_context(settings, matcher.shapes().end)),
        sizes_(settings.pieces),
        given_(canvas, settings.wishes, shapes),
        budget_(canvas, settings),
        own_replacer_(shapes, 1, [this] { check_stop(); }),
        replacer_(replacer ? *replacer : own_replacer_) {
    if (checkpoints.from) {
      restore(*checkpoints.from);
    } else {
      begin(0, given_.at_first());
    }
    setup_processor_s_ = processor_time_s() - processor_before_s_;
  }

  CollageResult finish() {
    try {
      do {
        if (!improving_) fill();
        if (improving_) improve();
      } while (begin_next_region());
    } catch (const StoppedBetween& stopped) {
      stop_unfinished(stopped.reason);
    } catch (const Interrupted& interrupted) {
      stop_unfinished(interrupted.reason);
      gave_up_question_ = true;
    }
    statistics_.total_s = seconds();
    if (keeper_) keeper_->keep(state());
    return {collage().placements(), statistics_, unfinished_, own_work(), gave_up_question_};
  }

 private:
  Collage& collage() const { return part_->collage; }
  Filling& filling() const { return part_->filling; }
  /// With the sizes of this attempt.
  const CollageSettings& sized() const { return part_->sized; }

  void check_stop() const {
    if (const auto reason = observer_.stop_requested()) throw StoppedBetween{{*reason}};
  }

  void begin(std::uint32_t region, StandingPieces standing) {
    const Canvas part = region_of(canvas_, region);
    part_ = std::make_unique<Part>(part, settings_, context_, sizes_.factor(), matcher_, shapes_, statistics_,
                                   [this] { check_stop(); });
    if (settings_.start.grow_outward) collage().grow_by(OutwardGrowth(part, sized().pieces, standing.pieces, shapes_));
    collage().begin(std::move(standing.pieces), standing.given, region);
    improving_ = false;
    moving_.clear();
    replaced_ = 0;
  }

  /// What stands is given to the next region, but for what may move there. False where there is none, or the run is
  /// over.
  bool begin_next_region() {
    const std::uint32_t next = collage().rules().limits().region + 1;
    if (unfinished_ || over_ || next >= canvas_.regions.size()) return false;
    begin(next, given_.when_begun(next, collage().placements()));
    return true;
  }

  /// With what stood when the region was begun: of `placements` the first `given`, and in the first region all that the
  /// job gives.
  void begin_again(std::uint32_t region, std::vector<Placement> placements, std::size_t given) {
    placements.resize(given);
    begin(region, region == 0 ? given_.at_first() : given_.when_begun_with(region, std::move(placements)));
  }

  bool all_wanted_stand() const { return collage().rules().shortage().pieces == 0; }

  /// Ends this attempt at sizes, and begins the next one. False where the collage is filled up as it is.
  bool begin_other_sizes() {
    if (sizes_.over()) return false;
    return unless_interrupted([&] {
      sizes_.end_attempt(collage().rules().shortage(), collage().placements());
      if (sizes_.over()) return go_back_to_best();
      begin_again(collage().rules().limits().region, collage().placements(), collage().rules().given());
      return true;
    });
  }

  /// Where the matcher interrupts `change` the collage has not changed yet: the attempts are put back, to fit it.
  bool unless_interrupted(const std::function<bool()>& change) {
    const SizeAttempts before = sizes_;
    try {
      return change();
    } catch (const Interrupted&) {
      sizes_ = before;
      throw;
    }
  }

  /// False where the best attempt is the last one.
  bool go_back_to_best() {
    const std::optional<std::vector<Placement>> best = sizes_.take_best();
    if (!best) return false;
    begin_again(collage().rules().limits().region, *best, collage().rules().given());
    collage().replace_placements(*best);
    collage().schedule().mark(collage().free().field().value.bounds());
    return true;
  }

  /// A limit of the job ends all attempts.
  void keep_best_attempt() {
    if (sizes_.over()) return;
    unless_interrupted([&] {
      sizes_.give_up(collage().rules().shortage(), collage().placements());
      return go_back_to_best();
    });
  }

  void restore(const CheckpointState& from) {
    if (from.region >= std::max<std::size_t>(1, canvas_.regions.size()) || from.given > from.placements.size() ||
        !sizes_.restore(from)) {
      throw InputError(from.name + ": not a checkpoint of this job: region " + std::to_string(from.region) +
                       ", attempt " + std::to_string(from.sizes.attempt) + "; --restart removes it and starts again");
    }
    for (std::size_t i = 0; i < from.given; ++i) {
      if (index_of(from.placements[i].shape) < context_.library_shapes) continue;
      throw InputError(from.name + ": not a checkpoint of this library; --restart removes it and starts again");
    }
    check_given(from);
    begin_again(from.region, from.placements, from.given);
    collage().restore(from);
    statistics_ = from.statistics;
    earlier_ = from.statistics;
    improving_ = from.improving;
    moving_ = from.moving;
    replaced_ = from.replaced;
    if (!filling().restore_empty_passes(from.empty_passes)) {
      throw InputError(from.name + ": not a checkpoint of this job: " +
                       count_text(std::size_t(from.empty_passes), "pass", "passes") +
                       " without a piece; --restart removes it and starts again");
    }
  }

  /// Of all that the job gives: improving may have taken some of them out since.
  std::uint64_t begun_with() const {
    Digest digest;
    for (const GivenPiece& piece : settings_.wishes.given) {
      const Similarity& pose = piece.canvas_from_shape;
      digest.add(std::uint64_t(index_of(piece.shape)) << 2 | std::uint64_t(piece.for_good) << 1 |
                 std::uint64_t(piece.locked));
      for (const float number : {pose.a, pose.b, pose.tx, pose.ty, piece.score, piece.matched_px}) {
        digest.add(std::bit_cast<std::uint32_t>(number));
      }
    }
    return digest.value();
  }

  void check_given(const CheckpointState& from) const {
    const std::size_t given = given_.at_first().given;
    const bool as_many = from.region > 0 ? from.given >= settings_.wishes.locked() : from.given == given;
    if (as_many && from.begun_with == begun_with()) return;
    throw InputError(from.name + ": begun with other pieces than [[given]] and start.pieces have now; give what they " +
                     "were then, or --restart, which removes it and starts again");
  }

  CheckpointState state() const {
    CheckpointState state;
    state.improving = improving_;
    state.empty_passes = improving_ ? 0 : filling().empty_passes();
    state.statistics = statistics_;
    state.statistics.total_s = seconds();
    state.statistics.stopped_by.reset();
    sizes_.save(state);
    state.begun_with = begun_with();
    state.moving = moving_;
    state.replaced = replaced_;
    collage().save(state);
    return state;
  }

  void fill() {
    if (moves_given_pieces_only()) {
      statistics_.stopped_by = why_filled();
      improving_ = improves();
      over_ = !improving_;
      return;
    }
    for (;;) {
      if (!sizes_.over() && (all_wanted_stand() || is_covered()) && begin_other_sizes()) continue;
      if (should_stop()) break;
      if (filling().place_one()) {
        after_step();
      } else if (!begin_other_sizes()) {
        statistics_.stopped_by = why_filled();
        improving_ = improves();
        return;
      }
    }
    if (over_) keep_best_attempt();
  }

  void improve() {
    statistics_.stopped_by = why_filled();
    filling().count_into(trial_work_);
    improve_clock_ = {statistics_.improve_s, {}};
    const auto first_trial = std::uint32_t(budget_.first_trial(region()));
    Improving improving(collage(), filling(), sized(), budget_.area_px2(region()), shapes_);
    // Pieces that were replaced come to rest, whatever limit was reached, and also if that was interrupted.
    while ((!moving_.empty() || (may_improve() && !reached_limit())) && !interrupted()) {
      if (moving_.empty() && statistics_.trials == first_trial + kTrialsBeforeReplacing) begin_replacing();
      try {
        if (moving_.empty()) {
          try_once(improving, first_trial);
        } else if (const std::uint64_t all = replacements(); replaced_ < all) {
          replace(all);
        } else {
          settle(improving);
        }
      } catch (const Interrupted&) {
        statistics_.improve_s = improve_clock_.seconds();
        throw;
      }
    }
  }

  void try_once(Improving& improving, std::uint32_t first_trial) {
    count(improving.try_once(
        std::uint32_t(statistics_.trials), [this] { return observer_.stop_requested(); }, first_trial));
  }

  /// Each piece is to be replaced once at least.
  void begin_replacing() {
    replaced_ = 0;
    if (pays_to_replace(sized()) && replacements() >= free_pieces()) moving_ = collage().placements();
  }

  /// As many as the phase has in all; no more than there were where time is over.
  std::uint64_t replacements() {
    if (!moving_.empty() && (!may_improve() || reached_limit())) return replaced_;
    return budget_.replacements(region(), free_pieces(), {replaced_, statistics_.improve_s, seconds()});
  }

  void replace(std::uint64_t all) {
    const auto poses_of = [this](const Placement& p) { return collage().rules().poses_of(p); };
    Replacing replacing(collage().free(), collage().rules().stances(), sized(), budget_.area_px2(region()), shapes_,
                        poses_of, replacer_);
    ReplacementProgress progress{replaced_, all};
    const Stopwatch asked;
    moving_ = replacing.batch(moving_, collage().rules().given(), progress, [this] { check_stop(); });
    trial_work_.replace_s += asked.seconds();
    statistics_.trials += progress.done / kReplacementsPerTrial - replaced_ / kReplacementsPerTrial;
    statistics_.improve_s = improve_clock_.seconds();
    replaced_ = progress.done;
    after_step();
  }

  /// The pieces come to rest, and are kept or put back.
  void settle(Improving& improving) {
    const Trial trial =
        improving.settle(moving_, std::uint32_t(statistics_.trials), [this] { return observer_.stop_requested(); });
    if (trial != Trial::interrupted) moving_.clear();
    count(trial);
  }

  void count(Trial trial) {
    statistics_.improve_s = improve_clock_.seconds();
    if (trial == Trial::interrupted) return;
    statistics_.trials_kept += trial == Trial::kept;
    ++statistics_.trials;
    after_step();
  }

  std::uint32_t region() const { return collage().rules().limits().region; }
  std::size_t free_pieces() const { return collage().placements().size() - collage().rules().given(); }
  bool may_improve() const { return budget_.may_go_on(region(), statistics_.trials, statistics_.improve_s); }

  void after_step() {
    observer_.progressed({collage().placements().size(), collage().covered_px2() / canvas_.area_px2, seconds(),
                          !moving_.empty(), collage().open_samples(), statistics_.trials,
                          std::uint64_t(settings_.improve.trials), sizes_.number()});
    if (keeper_ && keeper_->due()) keeper_->keep(state());
  }

  bool should_stop() {
    if (has_all_pieces(collage().placements().size())) {
      statistics_.stopped_by = StopReason::pieces;
      over_ = true;
      return true;
    }
    return reached_limit() || interrupted();
  }

  bool has_all_pieces(std::size_t pieces) const {
    return settings_.stop.pieces > 0 && pieces >= std::size_t(settings_.stop.pieces);
  }

  /// The pieces of an earlier result, as many as the job wants: who gives them free wants them improved.
  bool moves_given_pieces_only() const { return given_.any_free() && has_all_pieces(given_.size()); }

  bool improves() const { return settings_.improve.trials > 0 || settings_.improve.seconds > 0; }

  StopReason why_filled() const {
    if (moves_given_pieces_only()) return StopReason::pieces;
    return collage().rules().may_go_on() ? StopReason::full : StopReason::used_up;
  }

  bool is_covered() const { return collage().covered_px2() >= double(settings_.stop.coverage) * canvas_.area_px2; }

  /// That ends filling and improving alike.
  bool reached_limit() {
    const bool covered = is_covered();
    const bool late = settings_.stop.seconds > 0 && seconds() >= settings_.stop.seconds;
    if (covered || late) statistics_.stopped_by = late ? StopReason::seconds : StopReason::coverage;
    over_ = over_ || covered || late;
    return covered || late;
  }

  bool interrupted() {
    const std::optional<StopReason> reason = observer_.stop_requested();
    if (!reason) return false;
    stop_unfinished(*reason);
    return true;
  }

  void stop_unfinished(StopReason reason) {
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
  Matcher& matcher_;
  ShapeSource& shapes_;
  Observer& observer_;
  CheckpointKeeper* keeper_;
  MatchingContext context_;
  SizeAttempts sizes_;
  GivenPieces given_;
  ImprovingBudget budget_;
  RunStatistics statistics_;  // of the greedy part, with the number of trials
  RunStatistics trial_work_;
  std::unique_ptr<Part> part_;
  bool over_ = false;  // a limit of the job was reached
  double setup_processor_s_ = 0;
  Stopwatch watch_;
  RunStatistics earlier_;  // before an interruption
  bool improving_ = false;
  ImproveClock improve_clock_;
  OwnReplacer own_replacer_;
  Replacer& replacer_;
  std::vector<Placement> moving_;  // while pieces are replaced: where they are; they may not stand so
  std::uint64_t replaced_ = 0;     // trials of the phase
  bool unfinished_ = false;
  bool gave_up_question_ = false;
};

}  // namespace

CollageResult make_collage(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes,
                           Observer& observer, const Checkpoints& checkpoints, Replacer* replacer) {
  return Run(canvas, settings, matcher, shapes, observer, checkpoints, replacer).finish();
}

}  // namespace tessera::master
