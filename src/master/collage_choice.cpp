// Collage: chooses the candidate that becomes the next piece.
#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <utility>

#include "core/base/portable_math.h"
#include "core/base/stop.h"
#include "core/settings/tuning.h"
#include "master/collage.h"
#include "master/rules/acceptance.h"

namespace tessera::master {
namespace {

constexpr std::uint32_t kShapesLookedAt = 64;
constexpr std::size_t kGapShapes = 8;                // shapes that are tried in a wide gap
constexpr int kGapAttempts = 64;                     // poses that are settled in a wide gap
constexpr std::size_t kCheckedAhead = 64;            // candidates that are checked at a time
constexpr std::size_t kLookedAhead = 1024;           // candidates that are looked at to find them
constexpr std::uint64_t kFirstPiece = 0x6669727374;  // keeps these random numbers apart from those of the dockings

}  // namespace

/// Whether the candidate would look the same as one of the others.
bool Collage::repeats(const Candidate& candidate, std::span<const Candidate* const> others) const {
  return std::any_of(others.begin(), others.end(), [&](const Candidate* other) {
    return scoring_.look_alike(other->shape, candidate.shape) &&
           near_copy(other->canvas_from_shape, candidate.canvas_from_shape, kSameCandidate);
  });
}

/// The best candidates, of which no two look the same. While a batch is open, these are candidates that may join it. Only
/// candidates that are better than all of these are held back. So a choice that is interrupted finds the same again. Others
/// that have no room are put off, as they will have none before the batch ends: they are looked at once, not in each choice.
std::vector<Pool::Ranked> Collage::finalists() {
  using Visit = Pool::Visit;
  std::vector<Pool::Ranked> chosen;
  std::vector<const Candidate*> looks;
  int examined = 0;
  const auto worth_of = [&](const Candidate& c) { return worth(c); };
  pool_.best_first(worth_of, [&](const Pool::Ranked& ranked, const Candidate& c) {
    if (ranked.value < batch_.least_worth()) return Visit::last;
    if (batch_.is_open()) {
      if (chosen.empty()) {
        pool_.better_put_off(ranked, worth_of, [&](const Candidate& better) { batch_.hold_back(better.window); });
      }
      if (!batch_.has_room_for(c.window)) {
        if (!chosen.empty()) return Visit::put_off;
        batch_.hold_back(c.window);
        return Visit::set_aside;
      }
    }
    if (!repeats(c, looks)) {
      chosen.push_back(ranked);
      looks.push_back(&c);
    }
    return ++examined < kFinalistsExamined && chosen.size() < kFinalists ? Visit::next : Visit::last;
  });
  return chosen;
}

/// The candidates that will probably be finalists of the next choices, best first: those of finalists(), and more, as if
/// each candidate had been placed before the eighth after it comes.
std::vector<Candidate> Collage::likely_finalists() {
  using Visit = Pool::Visit;
  Batch ahead = batch_;
  std::vector<const Candidate*> likely;
  std::size_t visited = 0;
  const auto worth_of = [&](const Candidate& c) { return worth(c); };
  pool_.best_first(worth_of, [&](const Pool::Ranked& ranked, const Candidate& c) {
    if (ranked.value < ahead.least_worth() || ++visited > kLookedAhead) return Visit::last;
    if (!ahead.has_room_for(c.window)) return Visit::next;
    const std::size_t latest = std::min<std::size_t>(likely.size(), kFinalists);
    if (repeats(c, std::span(likely).last(latest))) return Visit::next;
    likely.push_back(&c);
    if (likely.size() >= kFinalists) {
      const Candidate& placed = *likely[likely.size() - kFinalists];
      if (ahead.has_room_for(placed.window)) ahead.add(placed.window, {}, worth(placed));
    }
    return likely.size() < kCheckedAhead ? Visit::next : Visit::last;
  });
  std::vector<Candidate> copies;
  for (const Candidate* candidate : likely) copies.push_back(*candidate);
  return copies;
}

/// Which of these finalists will probably be settled to become pieces, best first.
std::vector<Candidate> Collage::likely_pieces(const std::vector<Candidate>& finalists) const {
  std::vector<std::pair<float, const Candidate*>> by_worth;
  for (const Candidate& candidate : finalists) by_worth.emplace_back(worth(candidate), &candidate);
  std::stable_sort(by_worth.begin(), by_worth.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  Batch ahead = batch_;
  std::vector<Candidate> pieces;
  for (const auto& [value, candidate] : by_worth) {
    if (value < ahead.least_worth()) break;
    if (!ahead.has_room_for(candidate->window)) continue;
    ahead.add(candidate->window, {}, value);
    pieces.push_back(*candidate);
  }
  return pieces;
}

void Collage::check_ahead() {
  std::vector<Candidate> likely = likely_finalists();
  std::vector<Candidate> unchecked;
  std::copy_if(likely.begin(), likely.end(), std::back_inserter(unchecked),
               [](const Candidate& c) { return !c.exact; });
  checks_.compute_areas_ahead(unchecked);
  if (!settings_.settle) return;
  for (Candidate& candidate : likely) {
    if (!candidate.exact) score_exactly(candidate, checks_.areas(candidate));
  }
  checks_.settle_ahead(likely_pieces(likely));
}

void Collage::score_exactly(Candidate& candidate, const ExactAreas& areas) const {
  Candidate measured = candidate;
  measured.terms = with_exact_areas(candidate.terms, areas);
  candidate.score = score(measured);
  candidate.exact = true;
}

/// Makes a piece of the candidate and measures it again, as settling may change what it is worth.
Collage::Settled Collage::settle(Candidate& candidate) {
  const SettledPiece piece = checks_.settled(candidate);
  if (!piece.fits) return Settled::unfit;
  candidate.canvas_from_shape = piece.canvas_from_shape;
  candidate.terms = piece.terms;
  score_exactly(candidate, piece.areas);
  const bool shows_overlap =
      !overlaps_little(candidate) || !overlaps_little(candidate, piece.areas, settings_.pieces.padding_px);
  if (shows_overlap || !keeps_apart(candidate)) return Settled::unfit;
  return touches(candidate) ? Settled::fit : Settled::touches_too_little;
}

const HullRoom& Collage::room_of(ShapeId shape) {
  const auto found = rooms_.find(shape);
  return found != rooms_.end() ? found->second : rooms_.emplace(shape, hull_room(shapes_.shape(shape))).first->second;
}

/// The shapes that hardly dock and for which a gap of this width is enough. They come from the shapes that stand and may do
/// so again, and from some other open shapes, which differ from call to call.
std::vector<ShapeId> Collage::shapes_for_gap(float gap_px) {
  const StanceTable& stances = context().stances;
  std::set<ShapeId> shapes;
  for (const Placement& p : placements_) {
    if (stances.list(p.shape).count > 0) shapes.insert(p.shape);
  }
  const std::uint32_t open = stances.open_shapes();
  const auto begin = std::uint32_t(placements_.size() * kShapesLookedAt);
  for (std::uint32_t i = 0; i < std::min(open, kShapesLookedAt); ++i)
    shapes.insert(stances.open_shape((begin + i) % open));
  std::erase_if(shapes, [&](ShapeId shape) {
    const HullRoom& room = room_of(shape);
    return !room.hardly_docks() || gap_px < room.radius * stances.list(shape).min_scale_px;
  });
  return {shapes.begin(), shapes.end()};
}

std::vector<ShapeId> Collage::shapes_for_gap_in(const Window& window) {
  const float gap_px = widest_gap_px(free_, window);
  if (gap_px < kLeastWideGap * context().stances.least_scale_px()) return {};  // without a look at any shape
  return shapes_for_gap(gap_px);
}

bool Collage::leaves_wide_gap(const Window& window) { return !shapes_for_gap_in(window).empty(); }

/// Tries a few shapes, which differ from call to call, and takes the first that fits and touches as much as any piece must.
/// If no shape touches as much, it takes the one that touches most: a sun touches only with the tips of its rays.
bool Collage::choose_in_gap(Candidate& best, const Window& window, const StopCheck& check_stop) {
  if (growth_) return false;
  const std::vector<ShapeId> shapes = shapes_for_gap_in(window);
  int attempts = kGapAttempts;
  float most_matched = -1;  // part of its perimeter that `best` touches
  for (std::size_t k = 0; k < std::min(shapes.size(), kGapShapes); ++k) {
    const ShapeId id = shapes[(placements_.size() + k) % shapes.size()];
    const HullRoom& room = room_of(id);
    const ShapeModel& model = shapes_.model(id);
    const StanceList& list = context().stances.list(id);
    for (std::uint32_t s = 0; s < list.count && attempts > 0; ++s) {
      const auto settles = [&](const Similarity& pose) {
        check_stop();
        Candidate candidate;
        candidate.shape = id;
        candidate.stance = list.first + s;
        candidate.canvas_from_shape = pose;
        candidate.perimeter = model.perimeter;
        candidate.radius = model.radius;
        const Settled settled = settle(candidate);
        const float matched = candidate.terms.matched_px / (candidate.perimeter * candidate.canvas_from_shape.scale());
        if (settled == Settled::fit || (settled == Settled::touches_too_little && matched > most_matched)) {
          most_matched = matched;
          best = candidate;
        }
        return settled == Settled::fit || --attempts == 0;
      };
      const PoseRange& poses = context().stances[list.first + s].poses;
      if (any_pose_in_gap(model, room, poses, free_, window, check_stop, settles) && attempts > 0) return true;
    }
  }
  return most_matched >= 0;
}

/// Whether the first piece has to be chosen without docking. A canvas that repeats both ways has no boundary until
/// something stands, and pieces that grow outward do not dock to the canvas' edge.
bool Collage::needs_first_piece() const {
  if (placements_.size() != open_shapes_.given() || !(growth_ || free_.grid().period().repeats_both_ways()))
    return false;
  return !schedule_.any_may_dock();
}

/// Chooses a random shape for the middle, as large and as upright as it may be.
bool Collage::choose_first(Candidate& first, const StopCheck& check_stop) {
  const Window& nodes = free_.grid().one_period();
  Vec2 middle_px = free_.field().origin + Vec2{0.5f * float(nodes.x0 + nodes.x1), 0.5f * float(nodes.y0 + nodes.y1)};
  if (growth_) middle_px = growth_->first_piece_px();
  const StanceTable& stances = context().stances;
  float scale_px = context().max_scale_px;
  for (std::uint64_t draw = 0; draw < kFirstPieceDraws && stances.open_shapes() > 0; ++draw) {
    check_stop();
    const std::uint64_t random = mix_bits(settings_.seed ^ mix_bits(kFirstPiece ^ (draw << 32)));
    first = {};
    first.shape = stances.open_shape(std::uint32_t(((random >> 32) * stances.open_shapes()) >> 32));
    first.stance = stances.list(first.shape).first;
    const PoseRange poses = sized_at(context(), stances[first.stance], middle_px).poses;
    const Vec2 along = poses.rotations.middle * scale_px;
    first.canvas_from_shape = {along.x, along.y, middle_px.x, middle_px.y};
    poses.pull_in(first.canvas_from_shape);
    const ShapeModel& model = shapes_.model(first.shape);
    const SettledPose settled = settling_.settle(shapes_.shape(first.shape), model, poses, first.canvas_from_shape);
    first.canvas_from_shape = settled.canvas_from_shape;
    if (settled.fits) return true;
    scale_px = std::max(settings_.pieces.min_scale_px, kFirstPieceShrink * scale_px);
  }
  return false;
}

/// The finalists with exact scores, best first.
std::vector<Collage::Finalist> Collage::checked_finalists(const StopCheck& check_stop) {
  const std::vector<Pool::Ranked> finalists = this->finalists();
  const bool all_known = std::all_of(finalists.begin(), finalists.end(), [this](const Pool::Ranked& ranked) {
    const Candidate& candidate = pool_.at(ranked);
    return candidate.exact || checks_.knows_areas(candidate);
  });
  if (!all_known) check_ahead();
  std::vector<Finalist> checked;
  for (const Pool::Ranked& ranked : finalists) {
    check_stop();
    Finalist finalist{ranked, pool_.at(ranked)};
    if (!finalist.candidate.exact) score_exactly(finalist.candidate, checks_.areas(finalist.candidate));
    finalist.ranked.value = worth(finalist.candidate);
    checked.push_back(finalist);
  }
  std::sort(checked.begin(), checked.end(), [](const Finalist& a, const Finalist& b) { return a.ranked < b.ranked; });
  return checked;
}

/// Settles finalists until none of the rest can be worth more than the best settled one: settling may lower what a
/// candidate is worth. What is worth too little for the open batch waits.
bool Collage::settle_best(std::vector<Finalist>& finalists, Candidate& best, const StopCheck& check_stop) {
  float best_value = -1;
  for (Finalist& finalist : finalists) {
    if (best_value >= finalist.ranked.value) break;
    check_stop();
    Candidate settled = finalist.candidate;
    if (settle(settled) != Settled::fit) {
      finalist.given_up = true;
      continue;
    }
    const float value = worth(settled);
    finalist.waits = value < batch_.least_worth();
    if (finalist.waits || value <= best_value) continue;
    best_value = value;
    best = settled;
  }
  return best_value >= 0;
}

/// Writes what was found out about the finalists into the pool.
void Collage::keep_checks(std::vector<Finalist>& finalists) {
  for (Finalist& finalist : finalists) {
    Candidate& pooled = pool_.at(finalist.ranked);
    if (!pooled.exact) {
      pooled.score = finalist.candidate.score;
      pooled.exact = true;
      pool_.rank_again(finalist.ranked);
    }
    if (finalist.given_up) {
      pool_.erase(finalist.ranked);
    } else if (finalist.waits) {
      batch_.hold_back(pooled.window);
      pool_.set_aside(finalist.ranked);
    }
  }
}

/// Takes finalists from the pool, eight at a time, until one fits or none is left. The pool changes only after all
/// eight are judged, so a run that goes on after an interruption does the same.
bool Collage::choose(Candidate& best, const StopCheck& check_stop) {
  if (needs_first_piece()) return choose_first(best, check_stop);
  for (;;) {
    std::vector<Finalist> finalists = checked_finalists(check_stop);
    if (finalists.empty()) return false;
    bool found = true;
    if (settings_.settle) {
      found = settle_best(finalists, best, check_stop);
    } else {
      best = finalists.front().candidate;
    }
    keep_checks(finalists);
    if (found) return true;
  }
}

}  // namespace tessera::master
