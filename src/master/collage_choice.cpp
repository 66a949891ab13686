// Collage: which candidate becomes the next piece.
#include <algorithm>

#include "core/base/portable_math.h"
#include "core/tuning.h"
#include "master/collage.h"

namespace tessera::master {
namespace {

constexpr std::uint64_t kFirstPiece = 0x6669727374;  // keeps these random numbers apart from those of the dockings

}  // namespace

std::vector<Pool::Ranked> Collage::finalists() {
  std::vector<Pool::Ranked> chosen;
  std::vector<const Candidate*> looks;
  int examined = 0;
  const auto worth = [&](const Candidate& c) { return c.score * scoring_.preference(c); };
  pool_.best_first(worth, [&](const Pool::Ranked& ranked, const Candidate& c) {
    const bool repeated = std::any_of(looks.begin(), looks.end(), [&](const Candidate* other) {
      return scoring_.look_alike(other->shape, c.shape) &&
             near_copy(other->canvas_from_shape, c.canvas_from_shape, kSameCandidate);
    });
    if (!repeated) {
      chosen.push_back(ranked);
      looks.push_back(&c);
    }
    return ++examined < kFinalistsLookedAt && chosen.size() < kFinalists;
  });
  return chosen;
}

ExactAreas Collage::check_exactly(Candidate& candidate) {
  const ExactAreas areas = checks_.areas(candidate);
  Candidate measured = candidate;
  measured.terms = with_exact_areas(candidate.terms, areas);
  candidate.score = score(measured);
  candidate.exact = true;
  return areas;
}

void Collage::check_ahead() {
  for (const Pool::Ranked& ranked : finalists()) {
    const Candidate& candidate = pool_.at(ranked);
    if (!candidate.exact) checks_.compute_ahead(candidate);
  }
}

/// Makes a piece of the candidate, which may change what it is worth: that is measured again. False: it is given up.
bool Collage::settle(Candidate& candidate) {
  const Stance& stance = context_.stances[candidate.stance];
  const PoseRange poses = sized_at(context_, stance, candidate.canvas_from_shape.translation()).poses;
  if (!settling_.settle(candidate.shape, poses, candidate.canvas_from_shape)) return false;
  candidate.canvas_from_shape = free_.grid().period().wrapped(candidate.canvas_from_shape);
  candidate.terms = docking_terms(candidate.canvas_from_shape, shapes_.model(candidate.shape), free_.view(), context_);
  const ExactAreas areas = check_exactly(candidate);
  return scoring_.acceptable(candidate) && scoring_.overlaps_little(candidate, areas) && keeps_apart(candidate);
}

/// Where the canvas repeats both ways there is no boundary until something stands, and what grows outward docks to
/// none.
bool Collage::needs_first_piece() const {
  if (placements_.size() != given_ || !(growth_ || free_.grid().period().repeats_both_ways())) return false;
  const std::vector<SampleId> samples = curve_.samples();
  return std::none_of(samples.begin(), samples.end(), [&](SampleId id) { return may_dock(id); });
}

/// Any shape, large and as upright as it may be, in the middle.
bool Collage::choose_first(Candidate& first, const std::function<void()>& look) {
  const Window& nodes = free_.grid().one_period();
  Vec2 middle_px = free_.field().origin + Vec2{0.5f * float(nodes.x0 + nodes.x1), 0.5f * float(nodes.y0 + nodes.y1)};
  if (growth_) middle_px = growth_->first_piece_px();
  const StanceTable& stances = context_.stances;
  float scale_px = context_.max_scale_px;
  for (std::uint64_t draw = 0; draw < kFirstPieceDraws && stances.open_shapes() > 0; ++draw) {
    look();
    const std::uint64_t random = mix_bits(settings_.seed ^ mix_bits(kFirstPiece ^ (draw << 32)));
    first = {};
    first.shape = stances.open_shape(std::uint32_t(((random >> 32) * stances.open_shapes()) >> 32));
    first.stance = stances.list(first.shape).first;
    const PoseRange poses = sized_at(context_, stances[first.stance], middle_px).poses;
    const Vec2 along = poses.rotations.middle * scale_px;
    first.canvas_from_shape = {along.x, along.y, middle_px.x, middle_px.y};
    poses.pull_in(first.canvas_from_shape);
    if (settling_.settle(first.shape, poses, first.canvas_from_shape)) return true;
    scale_px = std::max(settings_.pieces.min_scale_px, kFirstPieceShrink * scale_px);
  }
  return false;
}

/// Best first.
std::vector<Collage::Finalist> Collage::checked_finalists(const std::function<void()>& look) {
  std::vector<Finalist> checked;
  for (const Pool::Ranked& ranked : finalists()) {
    look();
    Finalist finalist{ranked, pool_.at(ranked)};
    if (!finalist.candidate.exact) check_exactly(finalist.candidate);
    finalist.ranked.value = finalist.candidate.score * scoring_.preference(finalist.candidate);
    checked.push_back(finalist);
  }
  std::sort(checked.begin(), checked.end(), [](const Finalist& a, const Finalist& b) { return a.ranked < b.ranked; });
  return checked;
}

/// Settling may cost a candidate its place: it is the best only if no other is worth more before its own.
bool Collage::settle_best(std::vector<Finalist>& finalists, Candidate& best, const std::function<void()>& look) {
  float best_value = -1;
  for (Finalist& finalist : finalists) {
    if (best_value >= finalist.ranked.value) break;
    look();
    Candidate settled = finalist.candidate;
    if (!settle(settled)) {
      finalist.given_up = true;
      continue;
    }
    const float value = settled.score * scoring_.preference(settled);
    if (value <= best_value) continue;
    best_value = value;
    best = settled;
  }
  return best_value >= 0;
}

/// What was found out about the finalists, for the pool.
void Collage::keep_checks(std::vector<Finalist>& finalists) {
  for (Finalist& finalist : finalists) {
    Candidate& pooled = pool_.at(finalist.ranked);
    if (!pooled.exact) {
      pooled.score = finalist.candidate.score;
      pooled.exact = true;
      pool_.rank_again(finalist.ranked);
    }
    if (finalist.given_up) pool_.erase(finalist.ranked);
  }
}

/// Where nothing fits any more all of the pool is given up, eight at a time. The pool changes only where eight are
/// through: from there on a run that goes on does the same.
bool Collage::choose(Candidate& best, const std::function<void()>& look) {
  if (needs_first_piece()) return choose_first(best, look);
  for (;;) {
    std::vector<Finalist> finalists = checked_finalists(look);
    if (finalists.empty()) return false;
    bool found = true;
    if (settings_.settle) {
      found = settle_best(finalists, best, look);
    } else {
      best = finalists.front().candidate;
    }
    keep_checks(finalists);
    if (found) return true;
  }
}

}  // namespace tessera::master
