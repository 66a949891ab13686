// Rounds: place_one() comes first, then its steps: match, choose and merge.
#include "master/filling.h"

#include <optional>
#include <utility>

#include "core/base/processor_time.h"
#include "core/base/stop.h"
#include "core/base/stopwatch.h"
#include "core/settings/tuning.h"

namespace tessera::master {
namespace {

/// Extra searches while a wide gap is left. In its first search each sample then keeps the dockings that were drawn first.
/// Early reject counts points on lines as contact: sorted by key, dockings of line art come first that cross lines, and
/// none of them can be refined into a piece.
constexpr int kFirstDrawnSearches = 1;

}  // namespace

/// One piece. A round of the paper (section 4, Fig. 15) is a batch of pieces here: match the samples that are new, then
/// choose and merge the best candidate and others far from it.
bool Filling::place_one() {
  Candidate best;
  if (!find_further(best) && !find(best)) return false;
  place(best);
  return true;
}

/// Chooses another piece for the open batch. Where there is none, the batch ends.
bool Filling::find_further(Candidate& best) {
  if (!collage_.batch_is_open()) return false;
  if (choose(best)) return true;
  end_batch();
  return false;
}

/// Chooses the best candidate. Where there is none, it searches samples again.
bool Filling::find(Candidate& best) {
  for (;;) {
    match_samples();
    if (choose(best)) {
      search_ = 0;
      return true;
    }
    if (!search_again()) return choose_in_gap(best);
  }
}

/// An interruption before the merge leaves the batch open. Afterwards the master itself measures the candidates, so that the
/// batch ends before the interruption is thrown on.
void Filling::end_batch() {
  if (!collage_.batch_is_open()) return;
  Stopwatch watch;
  send_changes();
  collage_.merge_batch();
  const std::vector<Docking> touched = collage_.touched();
  statistics_->merge_s += watch.lap();
  std::vector<DockingTerms> terms;
  std::optional<Interrupted> interrupted;
  try {
    matcher_.post_measure(touched);
    terms = matcher_.take_measure();
  } catch (const Interrupted& interruption) {
    interrupted = interruption;
    terms = collage_.measure(touched);
  }
  statistics_->dock_s += watch.lap();
  collage_.end_batch(terms);
  statistics_->merge_s += watch.lap();
  if (interrupted) throw *interrupted;
}

void Filling::match_samples() {
  Stopwatch watch;
  send_changes();
  const std::vector<TargetSample> samples = collage_.schedule().take();
  statistics_->merge_s += watch.lap();
  try {
    const MatchRound found = match(matcher_, samples, plan(), library_pads_, *statistics_, [this] { check_ahead(); });
    watch.lap();
    collage_.add_candidates(samples, found);
  } catch (const Interrupted&) {
    collage_.schedule().put_back(samples);
    throw;
  }
  statistics_->objective_s += watch.lap();
}

bool Filling::choose(Candidate& best) {
  Stopwatch watch;
  const bool found = collage_.choose(best, check_stop_);
  statistics_->objective_s += watch.lap();
  return found;
}

void Filling::place(const Candidate& best) {
  Stopwatch watch;
  if (!collage_.batch_is_open()) ++statistics_->rounds;
  collage_.place(best);
  statistics_->merge_s += watch.lap();
}

Filling::Filling(Collage& collage, const MatchingContext& context, const CollageSettings& settings, Matcher& matcher,
                 RunStatistics& statistics, StopCheck check_stop)
    : collage_(collage),
      matcher_(matcher),
      statistics_(&statistics),
      check_stop_(std::move(check_stop)),
      searches_(settings.match.tangent_dockings > 0) {
  statistics_->shapes = context.library_shapes;
  statistics_->pads_per_shape = double(pads_per_shape(context));
  library_pads_ = pads_per_shape(context) * context.library_shapes;
  usual_plan_ = match_plan(settings.match, library_pads_);
  const CanvasField& field = collage.free().field();
  matcher.start_field(field.value.width(), field.value.height(), field.origin);
  start(field.value.bounds());
}

void Filling::start(const Window& region) {
  region_ = region;
  search_ = 0;
  wide_gap_.reset();
  collage_.schedule().search_in(region);
}

int Filling::most_searches() const { return searches_ ? kSearches + kFirstDrawnSearches : 0; }

/// Marks samples for their next search. False where each was searched often enough.
bool Filling::search_again() {
  if (!searches_) return false;
  SampleSchedule& schedule = collage_.schedule();
  search_ = schedule.mark_for_search(kSearches);
  if (search_ == 0 && wide_gap_is_left()) search_ = schedule.mark_for_search(most_searches());
  return search_ > 0;
}

bool Filling::wide_gap_is_left() {
  const std::size_t pieces = collage_.placements().size();
  if (!wide_gap_ || wide_gap_->pieces != pieces) wide_gap_ = WideGap{pieces, collage_.leaves_wide_gap(region_)};
  return wide_gap_->is_left;
}

MatchPlan Filling::plan() {
  if (search_ == 0) return usual_plan_;
  return {.tangent_dockings = std::uint32_t(kRematchTangentDockings),
          .first_drawn = search_ <= kFirstDrawnSearches && wide_gap_is_left()};
}

void Filling::check_ahead() {
  const double before_s = thread_processor_time_s();
  collage_.check_ahead();
  statistics_->ahead_s += thread_processor_time_s() - before_s;
}

bool Filling::choose_in_gap(Candidate& best) {
  Stopwatch watch;
  const bool found = searches_ && collage_.choose_in_gap(best, region_, check_stop_);
  statistics_->objective_s += watch.lap();
  return found;
}

void Filling::send_changes() {
  const OpenShapes& open = collage_.open_shapes();
  if (std::exchange(sent_version_, open.version()) != open.version()) matcher_.limit(open.limits());
  const FreeField& free = collage_.free();
  std::vector<FieldPatch> patches;
  for (const Window& changed : collage_.take_changed_nodes()) {
    for (const Window& part : free.grid().images(changed, free.grid().nodes())) {
      patches.push_back(read_patch(free.field().value, part));
    }
  }
  if (!patches.empty()) matcher_.update_field(patches);
}

}  // namespace tessera::master
