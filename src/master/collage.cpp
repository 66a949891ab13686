#include "master/collage.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <tuple>

#include "core/collage/objective.h"
#include "core/field/piece_distance.h"
#include "core/geometry/extent.h"
#include "core/matching/refinement.h"
#include "core/tuning.h"

namespace tessera::master {
namespace {

constexpr float kSameCandidate = 0.07f;  // of the scale: two finalists that would look the same
constexpr float kWindowMargin_px = 3;    // round the boundary points: a px for the outline's bulges between them
constexpr int kSettleSteps = 20;         // to come clear of neighbours that were placed since the refinement
constexpr float kSettleShrink = 0.99f;
constexpr int kExactSteps = 8;  // to correct what fields and boundary points did not see

double area_px2(const Placement& p) {
  const float scale = p.canvas_from_shape.scale();
  return double(scale) * scale;
}

/// Those that are in one of the two lists alone.
std::vector<Placement> difference(std::vector<Placement> a, std::vector<Placement> b) {
  const auto before = [](const Placement& p, const Placement& q) {
    const auto key = [](const Placement& x) {
      const Similarity& s = x.canvas_from_shape;
      return std::tuple(x.shape, s.tx, s.ty, s.a, s.b);
    };
    return key(p) < key(q);
  };
  std::sort(a.begin(), a.end(), before);
  std::sort(b.begin(), b.end(), before);
  std::vector<Placement> result;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result), before);
  return result;
}

}  // namespace

Collage::Collage(const Canvas& canvas, const CollageSettings& settings, const MatchingContext& context,
                 ShapeSource& shapes)
    : settings_(settings),
      context_(context),
      shapes_(shapes),
      free_(canvas, settings.pieces),
      opened_(free_, settings.pieces),
      curve_(settings.pieces, settings.match.pad),
      checks_(shapes, free_, opened_, settings_.pieces),
      outlines_(free_, settings.pieces),
      poses_(context.library_shapes),
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
    samples.back().pass = first_pass_ + passes_[edge]++;
  }
  stale_.clear();
  return samples;
}

void Collage::put_back_stale_samples(const std::vector<TargetSample>& samples) {
  for (const TargetSample& sample : samples) {
    stale_.insert(sample.edge);
    const auto passes = passes_.find(sample.edge);
    if (--passes->second == 0) passes_.erase(passes);
  }
}

void Collage::mark_stale(const Window& window) {
  for (const std::uint32_t edge : curve_.sample_edges()) {
    const Vec2 node = curve_.sample(edge).position - free_.field().origin;
    if (window.contains(int(node.x), int(node.y))) stale_.insert(edge);
  }
}

void Collage::add_candidates(const std::vector<TargetSample>& samples, const MatchRound& round) {
  std::vector<std::vector<Candidate>> of_sample(samples.size());
  for (const RefinedDocking& refined : round.refined) {
    const Docking& docking = refined.docking;
    Candidate candidate;
    candidate.shape = docking.shape;
    candidate.source = docking.source;
    candidate.canvas_from_shape = docking.canvas_from_shape;
    candidate.terms = refined.terms;
    candidate.perimeter = refined.perimeter;
    candidate.radius = refined.radius;
    if (!may_use(docking.shape) || !acceptable(candidate)) continue;
    candidate.score = score_of(candidate);
    candidate.window = nodes_round(refined.extent, free_.field().origin, context_.gap_px + kWindowMargin_px);
    of_sample[docking.sample].push_back(candidate);
  }
  for (std::size_t t = 0; t < samples.size(); ++t) {
    pool_.put(samples[t].edge, std::move(of_sample[t]), round.truncated[t]);
  }
}

bool Collage::may_use(std::uint32_t shape) const {
  return settings_.pieces.uses == 0 || poses_[shape].size() < std::size_t(settings_.pieces.uses);
}

/// Repetition costs something, or one shape that fits everywhere fills the canvas (design, method 8).
float Collage::preference(const Candidate& candidate) const {
  const std::vector<Similarity>& placed = poses_[candidate.shape];
  if (placed.empty()) return 1;
  float factor = std::pow(1.f + float(placed.size()), -settings_.objective.repetition_exponent);
  const float radius = candidate.radius + 0.5f;
  for (const Similarity& pose : placed) {
    const float near = radius * (pose.scale() + candidate.canvas_from_shape.scale());
    const Vec2 apart = pose.translation() - candidate.canvas_from_shape.translation();
    if (dot(apart, apart) < near * near) factor *= settings_.objective.near_twin_factor;
  }
  return factor;
}

float Collage::score_of(const Candidate& candidate) const {
  const float scale = candidate.canvas_from_shape.scale();
  const PieceSize size{scale, candidate.perimeter * scale, context_.poses.max_scale_px};
  return objective(candidate.terms, size, settings_.objective);
}

bool Collage::acceptable(const Candidate& candidate) const {
  const float scale = candidate.canvas_from_shape.scale();
  return candidate.terms.overlap_px2 <= kMaxOverlap * scale * scale &&
         candidate.terms.matched_px >= kLeastMatched * candidate.perimeter * scale;
}

std::vector<Pool::Ranked> Collage::finalists() {
  std::vector<Pool::Ranked> chosen;
  std::vector<const Candidate*> looks;
  int examined = 0;
  const auto worth = [&](const Candidate& c) { return c.score * preference(c); };
  pool_.best_first(worth, [&](const Pool::Ranked& ranked, const Candidate& c) {
    const bool repeated = std::any_of(looks.begin(), looks.end(), [&](const Candidate* other) {
      return other->shape == c.shape && near_copy(other->canvas_from_shape, c.canvas_from_shape, kSameCandidate);
    });
    if (!repeated) {
      chosen.push_back(ranked);
      looks.push_back(&c);
    }
    return ++examined < 8 * kFinalists && chosen.size() < kFinalists;
  });
  return chosen;
}

void Collage::check_exactly(Candidate& candidate) {
  const ExactAreas areas = checks_.areas(candidate);
  Candidate measured = candidate;
  measured.terms = with_exact_areas(candidate.terms, areas);
  candidate.score = score_of(measured);
  candidate.exact = true;
}

void Collage::check_ahead() {
  for (const Pool::Ranked& ranked : finalists()) {
    const Candidate& candidate = pool_.at(ranked);
    if (!candidate.exact) checks_.compute_ahead(candidate);
  }
}

/// What was placed since may reach into the candidate: push it free, or give it up. Then it grows, and what it is worth
/// is measured again.
bool Collage::settle(Candidate& candidate) {
  if (!push_clear(candidate)) return false;
  const ShapeModel& model = shapes_.model(candidate.shape);
  grow(candidate.canvas_from_shape, model, free_.view(), context_);
  if (!fit_exactly(candidate)) return false;
  candidate.terms = docking_terms(candidate.canvas_from_shape, model, free_.view(), context_);
  check_exactly(candidate);
  return acceptable(candidate);
}

/// By the free field, as in the refinement.
bool Collage::push_clear(Candidate& candidate) {
  const ShapeModel& model = shapes_.model(candidate.shape);
  const FieldView field = free_.view();
  Similarity& pose = candidate.canvas_from_shape;
  for (int step = 0; depth_px(pose, model, field) > context_.hard_depth_px; ++step) {
    if (step == kSettleSteps) return false;
    descend(pose, model, field, {2, 0.3f, 0.3f, 30.f, kMediumStride}, context_.poses);
    if (depth_px(pose, model, field) <= context_.hard_depth_px) break;
    pose.a *= kSettleShrink;
    pose.b *= kSettleShrink;
    if (pose.scale() < context_.poses.min_scale_px) return false;
  }
  return true;
}

/// By the outlines themselves.
bool Collage::fit_exactly(Candidate& candidate) {
  const Shape& shape = shapes_.shape(candidate.shape);
  Similarity& pose = candidate.canvas_from_shape;
  for (int step = 0; step < kExactSteps; ++step) {
    const std::vector<Vec2> ways = outlines_.conflicts(shape, pose);
    if (ways.empty()) return true;
    for (const Vec2& way : ways) {
      pose.tx += way.x;
      pose.ty += way.y;
    }
    if (step == 0) continue;
    pose.a *= kSettleShrink;
    pose.b *= kSettleShrink;
    context_.poses.pull_in(pose);
  }
  return false;
}

/// Settling may cost a candidate its place: it is the best only if no other is worth more before its own.
bool Collage::choose(Candidate& best) {
  for (;;) {
    std::vector<Pool::Ranked> ranked = finalists();
    for (Pool::Ranked& r : ranked) {
      Candidate& c = pool_.at(r);
      if (!c.exact) {
        check_exactly(c);
        pool_.rank_again(r);
      }
      r.value = c.score * preference(c);
    }
    if (ranked.empty()) return false;
    std::sort(ranked.begin(), ranked.end());
    if (!settings_.settle) {
      best = pool_.at(ranked.front());
      return true;
    }
    float best_value = -1;
    std::vector<Pool::Ranked> given_up;
    for (const Pool::Ranked& r : ranked) {
      if (best_value >= r.value) break;
      Candidate settled = pool_.at(r);
      if (!settle(settled)) {
        given_up.push_back(r);
        continue;
      }
      const float value = settled.score * preference(settled);
      if (value <= best_value) continue;
      best_value = value;
      best = settled;
    }
    for (const Pool::Ranked& r : given_up) pool_.erase(r);
    if (best_value >= 0) return true;
  }
}

Window Collage::place(const Candidate& candidate) {
  const Shape& shape = shapes_.shape(candidate.shape);
  placements_.push_back(
      {candidate.shape, candidate.canvas_from_shape, candidate.score, candidate.terms.matched_px});
  outlines_.add(placements_.back(), shape.outline);
  poses_[candidate.shape].push_back(candidate.canvas_from_shape);
  covered_px2_ += area_px2(placements_.back());
  const Window changed = free_.stamp(shape, candidate.canvas_from_shape);
  changed_nodes_ = changed_nodes_.united(changed);
  retrace(changed);
  if (!may_use(candidate.shape)) drop_shape(candidate.shape);
  return piece_window(shape.outline, candidate.canvas_from_shape, free_.field().origin,
                      2 + kept_distance_px(settings_.pieces));
}

Window Collage::replace_placements(std::vector<Placement> placements) {
  const std::vector<Placement> changed = difference(placements_, placements);
  placements_ = std::move(placements);
  outlines_.replace(placements_, shapes_);
  for (std::vector<Similarity>& poses : poses_) poses.clear();
  covered_px2_ = 0;
  for (const Placement& p : placements_) {
    poses_[p.shape].push_back(p.canvas_from_shape);
    covered_px2_ += area_px2(p);
  }
  pool_ = {};
  checks_.forget_all();
  stale_.clear();
  passes_.clear();
  curve_.set_matched_pads({});
  const Window restamped = restamp(changed);
  changed_nodes_ = changed_nodes_.united(restamped);
  retrace(restamped);
  Window window;
  for (const Placement& p : changed) {
    window = window.united(piece_window(shapes_.shape(p.shape).outline, p.canvas_from_shape, free_.field().origin, 4));
  }
  return window;
}

/// The free field anew in the windows of the pieces that come and go.
Window Collage::restamp(const std::vector<Placement>& changed) {
  Window window;
  for (const Placement& p : changed) window = window.united(stamp_window(p));
  free_.clear(window);
  for (const Placement& p : placements_) {
    const Window common = stamp_window(p).intersected(window);
    if (!common.empty()) free_.stamp(shapes_.shape(p.shape), p.canvas_from_shape, common);
  }
  return window;
}

float Collage::distance_px(const Placement& p, Vec2 point_px) {
  return PieceDistance(shapes_.shape(p.shape), p.canvas_from_shape, 0).at(point_px);
}

Window Collage::stamp_window(const Placement& p) { return free_.stamp_window(shapes_.shape(p.shape), p.canvas_from_shape); }

void Collage::retrace(const Window& changed) {
  const Window window = opened_.update(free_, changed);
  checks_.forget(window);
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

void Collage::drop_shape(std::uint32_t shape) {
  std::vector<std::uint32_t> edges;
  for (const auto& [edge, entry] : pool_.entries()) edges.push_back(edge);
  for (const std::uint32_t edge : edges) review(edge, [&](Candidate& c) { return c.shape != shape; });
}

std::vector<Docking> Collage::touched_by(const Window& changed) const {
  std::vector<Docking> touched;
  for (const std::uint32_t edge : pool_.reached_by(changed)) {
    for (const Candidate& c : pool_.entries().at(edge).candidates) {
      if (c.window.overlaps(changed)) touched.push_back({edge, c.shape, c.source, 0, c.canvas_from_shape});
    }
  }
  return touched;
}

std::vector<DockingTerms> Collage::measure(const std::vector<Docking>& dockings) {
  std::vector<DockingTerms> terms;
  for (const Docking& docking : dockings) {
    terms.push_back(docking_terms(docking.canvas_from_shape, shapes_.model(docking.shape), free_.view(), context_));
  }
  return terms;
}

void Collage::rescore(const Window& changed, const std::vector<DockingTerms>& terms) {
  auto measured = terms.begin();
  for (const std::uint32_t edge : pool_.reached_by(changed)) {
    review(edge, [&](Candidate& c) {
      if (!c.window.overlaps(changed)) return true;
      if (measured == terms.end()) throw std::logic_error("fewer candidates were measured than touched");
      c.terms = *measured++;
      if (!acceptable(c)) return false;
      c.score = score_of(c);
      c.exact = false;
      return true;
    });
  }
}

/// A target sample that loses most of its candidates is matched again where there were more.
template <class Keep>
void Collage::review(std::uint32_t edge, Keep keep) {
  const bool lost = pool_.review(edge, keep);
  const Pool::Entry& entry = pool_.entries().at(edge);
  if (lost && entry.candidates.size() < kRefillBelow && entry.truncated) stale_.insert(edge);
}

}  // namespace tessera::master
