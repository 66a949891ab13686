#include "master/collage.h"

#include <algorithm>
#include <cmath>

#include "core/exact_terms.h"
#include "core/objective.h"
#include "core/refinement.h"
#include "core/tuning.h"

namespace tessera::master {
namespace {

constexpr float kSameCandidate = 0.07f;  // of the scale: two finalists that would look the same
constexpr int kSettleSteps = 20;         // to come clear of neighbours that were placed since the refinement
constexpr float kSettleShrink = 0.99f;

}  // namespace

struct Collage::Ranked {
  float value;  // score times preference
  std::uint32_t edge;
  std::size_t index;

  /// A total order: the same finalists in the same order on any machine.
  bool operator<(const Ranked& o) const {
    if (value != o.value) return value > o.value;
    return edge != o.edge ? edge < o.edge : index < o.index;
  }
};

Collage::Collage(const Canvas& canvas, const CollageSettings& settings, const MatchingContext& context,
                 ShapeSource& shapes)
    : settings_(settings),
      context_(context),
      shapes_(shapes),
      free_(canvas, settings.pieces),
      opened_(free_, settings.pieces),
      curve_(settings.pieces, settings.match.pad),
      uses_(context.library_shapes, 0),
      changed_nodes_(free_.field().value.bounds()) {
  retrace(changed_nodes_);
}

Window Collage::take_changed_nodes() {
  const Window changed = changed_nodes_;
  changed_nodes_ = {};
  return changed;
}

std::vector<TargetSample> Collage::take_stale_samples() {
  std::vector<TargetSample> samples;
  for (const std::uint32_t edge : stale_) {
    samples.push_back(curve_.sample(edge));
    samples.back().pass = passes_[edge]++;
  }
  stale_.clear();
  return samples;
}

void Collage::mark_all_stale() {
  for (const std::uint32_t edge : curve_.sample_edges()) stale_.insert(edge);
}

void Collage::add_candidates(const std::vector<TargetSample>& samples, const MatchRound& round) {
  std::vector<std::vector<Candidate>> of_sample(samples.size());
  for (const RefinedDocking& refined : round.refined) {
    const Docking& docking = refined.docking;
    Candidate candidate{docking.shape, docking.source, docking.canvas_from_shape, refined.terms, 0, false, {}};
    if (!may_use(docking.shape) || !acceptable(candidate)) continue;
    candidate.score = score_of(candidate);
    candidate.window = piece_window(shapes_.shape(candidate.shape).outline, candidate.canvas_from_shape,
                                    free_.field().origin, context_.gap_px + 2);
    of_sample[docking.sample].push_back(candidate);
  }
  for (std::size_t t = 0; t < samples.size(); ++t) {
    pool_.put(samples[t].edge, std::move(of_sample[t]), round.truncated[t]);
  }
}

bool Collage::may_use(std::uint32_t shape) const {
  return settings_.pieces.uses == 0 || uses_[shape] < std::uint32_t(settings_.pieces.uses);
}

/// Repetition costs something, or one shape that fits everywhere fills the canvas (design, method 8).
float Collage::preference(const Candidate& candidate) const {
  const std::uint32_t uses = uses_[candidate.shape];
  if (uses == 0) return 1;
  float factor = std::pow(1.f + float(uses), -settings_.objective.repetition_exponent);
  const float radius = shapes_.model(candidate.shape).radius + 0.5f;
  for (const Placement& placed : placements_) {
    if (placed.shape != candidate.shape) continue;
    const float near = radius * (placed.canvas_from_shape.scale() + candidate.canvas_from_shape.scale());
    const Vec2 apart = placed.canvas_from_shape.translation() - candidate.canvas_from_shape.translation();
    if (dot(apart, apart) < near * near) factor *= settings_.objective.near_twin_factor;
  }
  return factor;
}

float Collage::score_of(const Candidate& candidate) const {
  const float scale = candidate.canvas_from_shape.scale();
  const PieceSize size{scale, shapes_.model(candidate.shape).perimeter * scale, context_.max_scale_px};
  return objective(candidate.terms, size, settings_.objective);
}

bool Collage::acceptable(const Candidate& candidate) const {
  const float scale = candidate.canvas_from_shape.scale();
  return candidate.terms.overlap_px2 <= kMaxOverlap * scale * scale &&
         candidate.terms.matched_px >= kLeastMatched * shapes_.model(candidate.shape).perimeter * scale;
}

std::vector<Collage::Ranked> Collage::finalists() {
  std::vector<Ranked> ranked;
  for (auto& [edge, entry] : pool_.entries()) {
    for (std::size_t i = 0; i < entry.candidates.size(); ++i) {
      ranked.push_back({entry.candidates[i].score * preference(entry.candidates[i]), edge, i});
    }
  }
  const std::size_t examined = std::min<std::size_t>(ranked.size(), 8 * kFinalists);
  std::partial_sort(ranked.begin(), ranked.begin() + examined, ranked.end());
  std::vector<Ranked> chosen;
  for (std::size_t i = 0; i < examined && chosen.size() < kFinalists; ++i) {
    const Candidate& c = pool_.entries().at(ranked[i].edge).candidates[ranked[i].index];
    const bool repeated = std::any_of(chosen.begin(), chosen.end(), [&](const Ranked& r) {
      const Candidate& other = pool_.entries().at(r.edge).candidates[r.index];
      return other.shape == c.shape && near_copy(other.canvas_from_shape, c.canvas_from_shape, kSameCandidate);
    });
    if (!repeated) chosen.push_back(ranked[i]);
  }
  return chosen;
}

void Collage::check_exactly(Candidate& candidate) {
  const ExactAreas areas =
      exact_areas(shapes_.shape(candidate.shape), candidate.canvas_from_shape, free_, opened_, settings_.pieces);
  DockingTerms exact = candidate.terms;
  exact.overlap_px2 = areas.overlap_px2;
  exact.gap_px2 = areas.gap_px2;
  Candidate measured = candidate;
  measured.terms = exact;
  candidate.score = score_of(measured);
  candidate.exact = true;
}

/// What was placed since may reach into the candidate: push it free, or give it up. Then it grows.
bool Collage::settle(Candidate& candidate) {
  const ShapeModel& model = shapes_.model(candidate.shape);
  const FieldView field = free_.view();
  Similarity& pose = candidate.canvas_from_shape;
  for (int step = 0; depth_px(pose, model, field) > kHardDepth_px; ++step) {
    if (step == kSettleSteps) return false;
    descend(pose, model, field, {2, 0.3f, 0.3f, 30.f, kMediumStride}, context_.min_scale_px, context_.max_scale_px);
    if (depth_px(pose, model, field) <= kHardDepth_px) break;
    pose.a *= kSettleShrink;
    pose.b *= kSettleShrink;
    if (pose.scale() < context_.min_scale_px) return false;
  }
  if (!context_.rotation_allowed(pose)) return false;
  grow(pose, model, field, context_);
  candidate.terms = docking_terms(pose, model, field, context_);
  return true;
}

bool Collage::choose(Candidate& best) {
  for (;;) {
    std::vector<Ranked> ranked = finalists();
    for (Ranked& r : ranked) {
      Candidate& c = pool_.entries().at(r.edge).candidates[r.index];
      if (!c.exact) check_exactly(c);
      r.value = c.score * preference(c);
    }
    const auto first = std::min_element(ranked.begin(), ranked.end());
    if (first == ranked.end()) return false;
    std::vector<Candidate>& candidates = pool_.entries().at(first->edge).candidates;
    best = candidates[first->index];
    if (best.score < kLeastScore) return false;
    if (!settings_.settle || settle(best)) return true;
    candidates.erase(candidates.begin() + std::ptrdiff_t(first->index));
  }
}

void Collage::place(const Candidate& candidate) {
  const Shape& shape = shapes_.shape(candidate.shape);
  placements_.push_back(
      {candidate.shape, candidate.canvas_from_shape, candidate.score, candidate.terms.matched_px});
  ++uses_[candidate.shape];
  const float scale = candidate.canvas_from_shape.scale();
  covered_px2_ += double(scale) * scale;
  const Window changed = free_.stamp(shape, candidate.canvas_from_shape);
  changed_nodes_ = changed_nodes_.united(changed);
  retrace(changed);
  rescore(piece_window(shape.outline, candidate.canvas_from_shape, free_.field().origin, 2 + settings_.pieces.padding_px));
}

void Collage::retrace(const Window& changed) {
  const Window window = opened_.update(free_, changed);
  const TargetCurve::Change change = curve_.retrace(opened_, free_.field().origin, window);
  for (const std::uint32_t edge : change.removed) {
    pool_.erase(edge);
    stale_.erase(edge);
  }
  for (const std::uint32_t edge : change.renewed) {
    pool_.erase(edge);
    stale_.insert(edge);
  }
}

void Collage::rescore(const Window& changed) {
  for (auto& [edge, entry] : pool_.entries()) {
    std::size_t kept = 0;
    for (Candidate& c : entry.candidates) {
      if (!may_use(c.shape)) continue;
      if (c.window.overlaps(changed)) {
        c.terms = docking_terms(c.canvas_from_shape, shapes_.model(c.shape), free_.view(), context_);
        if (!acceptable(c)) continue;
        c.score = score_of(c);
        c.exact = false;
      }
      if (&entry.candidates[kept] != &c) entry.candidates[kept] = c;
      ++kept;
    }
    const bool lost = kept < entry.candidates.size();
    entry.candidates.resize(kept);
    if (lost && kept < kRefillBelow && entry.truncated) stale_.insert(edge);
  }
}

}  // namespace tessera::master
