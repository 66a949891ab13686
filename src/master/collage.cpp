#include "master/collage.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <tuple>

#include "core/field/piece_distance.h"
#include "core/geometry/extent.h"
#include "core/matching/size_schedule.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_field.h"

namespace tessera::master {
namespace {

/// Files of results have poses to three decimals, of px and degrees.
bool is_rounded_out_of(const PoseRange& poses, Similarity pose) {
  constexpr float kRounding_px = 0.0006f;
  constexpr float kRounding_rad = 1e-5f;
  const Vec2 written{pose.a, pose.b};
  poses.pull_in(pose);
  return norm(Vec2{pose.a, pose.b} - written) < kRounding_px + kRounding_rad * pose.scale();
}

double area_px2(const Placement& p) {
  const float scale = p.canvas_from_shape.scale();
  return double(scale) * scale;
}

/// Else the piece would reach its own image.
bool fits_into(const Period& period, const Extent& piece) {
  const Vec2 size = piece.high - piece.low;
  return (period.x_px == 0 || size.x <= float(period.x_px)) && (period.y_px == 0 || size.y <= float(period.y_px));
}

/// The image whose centre lies in the first period stands for all.
void bring_into_one_period(Candidate& candidate, const Period& period) {
  const Vec2 found = candidate.canvas_from_shape.translation();
  candidate.canvas_from_shape = period.wrapped(candidate.canvas_from_shape);
  const Vec2 by = candidate.canvas_from_shape.translation() - found;
  const int dx = int(std::lround(by.x));
  const int dy = int(std::lround(by.y));
  Window& window = candidate.window;
  window = {window.x0 + dx, window.y0 + dy, window.x1 + dx, window.y1 + dy};
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

/// Of two ascending lists, like the next.
std::vector<ShapeId> without(const std::vector<ShapeId>& all, const std::vector<ShapeId>& some) {
  std::vector<ShapeId> rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

std::vector<ShapeId> joined(const std::vector<ShapeId>& a, const std::vector<ShapeId>& b) {
  std::vector<ShapeId> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

std::vector<ShapeId> silhouettes_of(const ShapeSource& shapes, std::uint32_t count) {
  std::vector<ShapeId> silhouettes;
  for (std::uint32_t shape = 0; shape < count; ++shape) silhouettes.push_back(shapes.silhouette(ShapeId(shape)));
  return silhouettes;
}

std::vector<ShapeId> drawings_of(const ShapeSource& shapes, std::uint32_t count) {
  std::vector<ShapeId> drawings;
  for (std::uint32_t shape = 0; shape < count; ++shape) drawings.push_back(shapes.drawing(ShapeId(shape)));
  return drawings;
}

}  // namespace

Collage::Collage(const Canvas& canvas, const CollageSettings& settings, const MatchingContext& context,
                 ShapeSource& shapes, float size_factor)
    : settings_(settings),
      context_(context),
      all_stances_(context.stances),
      limits_{.size_factor = size_factor},
      shapes_(shapes),
      free_(canvas, settings.pieces),
      opened_(free_, settings.pieces),
      curve_(settings.pieces, settings.match.pad),
      checks_(shapes, free_, opened_, settings_.pieces),
      outlines_(free_, settings.pieces),
      scoring_(settings, context.stances, silhouettes_of(shapes, context.library_shapes), canvas.period,
               drawings_of(shapes, context.library_shapes)),
      apart_(settings, shapes, canvas.period),
      settling_(shapes, free_, outlines_, context_),
      changed_nodes_(free_.field().value.bounds()) {
  limit(limits_);
  region_stances_ = context_.stances;
  retrace(changed_nodes_);
  update_limits();
}

void Collage::begin(std::vector<Placement> standing, std::size_t given, std::uint32_t region) {
  limit({.region = region, .size_factor = limits_.size_factor});
  region_stances_ = context_.stances;
  given_ = given;
  replace_placements(std::move(standing));
  mark_stale(free_.field().value.bounds());
}

std::vector<ShapeId> Collage::missing() const {
  if (!scoring_.limits_uses()) return {};
  std::vector<ShapeId> missing;
  for (std::uint32_t i = 0; i < region_stances_.open_shapes(); ++i) {
    const ShapeId shape = region_stances_.open_shape(i);
    if (scoring_.missing_uses(shape) > 0) missing.push_back(shape);
  }
  return missing;
}

Shortage Collage::shortage() const {
  if (!scoring_.limits_uses()) return {};
  Shortage shortage;
  double wanted_px2 = 0;
  double missing_px2 = 0;
  for (std::uint32_t i = 0; i < region_stances_.open_shapes(); ++i) {
    const ShapeId shape = region_stances_.open_shape(i);
    if (shapes_.drawing(shape) != shape) continue;  // one of the two takes the places of both
    const StanceList& stances = region_stances_.list(shape);
    const double px2 = double(stances.min_scale_px) * double(stances.max_scale_px);
    wanted_px2 += scoring_.least_uses(shape) * px2;
    missing_px2 += scoring_.missing_uses(shape) * px2;
    shortage.pieces += std::uint64_t(scoring_.missing_uses(shape));
  }
  if (shortage.pieces > 0) shortage.placed = 1 - missing_px2 / wanted_px2;
  return shortage;
}

float Collage::most_scale_for(const std::vector<ShapeId>& missing) const {
  std::vector<WantedPieces> left;
  for (const ShapeId shape : missing) {
    if (shapes_.drawing(shape) != shape) continue;  // one of the two takes the places of both
    const StanceList& stances = region_stances_.list(shape);
    left.push_back({{stances.min_scale_px, stances.max_scale_px}, double(scoring_.missing_uses(shape))});
  }
  return most_scale_px(double(free_.free_256ths_px2()) / 256, left);
}

bool Collage::may_go_on() const {
  StandingLimits by_uses = limits_;
  by_uses.used_up = scoring_.closed_shapes(missing());
  return all_stances_.limited(by_uses).open_shapes() > 0;
}

/// By the distances that pieces keep from their like.
std::vector<ShapeId> Collage::shut_out_shapes() const {
  if (!apart_.matters()) return {};
  return apart_.shut_out(context_.library_shapes, [this](const auto& holds) { return curve_.any_position(holds); });
}

/// They follow from the placements: whatever came and went, the same may stand.
void Collage::update_limits() {
  if (!scoring_.limits_uses() && !apart_.matters()) return;
  const std::vector<ShapeId> shut_out = shut_out_shapes();
  std::vector<ShapeId> missing = this->missing();
  // Other shapes do not wait for one that has no place now. With fit = "all" they do: it needs smaller sizes.
  if (!settings_.pieces.fit_all) missing = without(missing, shut_out);
  StandingLimits now{.region = limits_.region, .size_factor = limits_.size_factor};
  now.used_up = joined(scoring_.closed_shapes(missing), shut_out);
  if (settings_.pieces.fit_all && !missing.empty()) now.most_scale_px = most_scale_for(missing);
  if (now == limits_) return;
  limit(now);
  drop_what_may_not_stand();
}

void Collage::limit(const StandingLimits& limits) {
  limits_ = limits;
  limits_changed_ = true;
  tessera::limit(context_, all_stances_, limits);
}

Window Collage::take_changed_nodes() {
  const Window changed = changed_nodes_;
  changed_nodes_ = {};
  return changed;
}

std::vector<TargetSample> Collage::take_stale_samples() {
  std::vector<TargetSample> samples;
  for (const SampleId id : stale_) {
    samples.push_back(curve_.sample(id));
    samples.back().pass = first_pass_ + passes_[id]++;
  }
  stale_.clear();
  return samples;
}

void Collage::put_back_stale_samples(const std::vector<TargetSample>& samples) {
  for (const TargetSample& sample : samples) {
    stale_.insert(sample.id);
    const auto passes = passes_.find(sample.id);
    if (--passes->second == 0) passes_.erase(passes);
  }
}

void Collage::mark_stale(const Window& window) {
  for (const SampleId id : curve_.samples()) {
    const Vec2 node = curve_.sample(id).position - free_.field().origin;
    const int x = int(node.x);
    const int y = int(node.y);
    if (may_dock(id) && free_.grid().overlap(window, {x, y, x + 1, y + 1})) stale_.insert(id);
  }
}

bool Collage::may_dock(SampleId id) const { return !growth_ || growth_->may_dock(free_, curve_.sample(id).position); }

float Collage::score(const Candidate& candidate) const {
  const float score = scoring_.score(candidate);
  return growth_ ? score * growth_->nearness(candidate.canvas_from_shape.translation()) : score;
}

void Collage::add_candidates(const std::vector<TargetSample>& samples, const MatchRound& round) {
  std::vector<std::vector<Candidate>> of_sample(samples.size());
  for (const RefinedDocking& refined : round.refined) {
    const Docking& docking = refined.docking;
    Candidate candidate;
    candidate.shape = docking.shape;
    candidate.source = docking.source;
    candidate.stance = docking.stance;
    candidate.canvas_from_shape = docking.canvas_from_shape;
    candidate.terms = refined.terms;
    candidate.perimeter = refined.perimeter;
    candidate.radius = refined.radius;
    if (!scoring_.may_use(docking.shape) || !scoring_.acceptable(candidate) || !keeps_apart(candidate)) continue;
    if (!fits_into(free_.grid().period(), refined.extent)) continue;
    candidate.score = score(candidate);
    candidate.window = nodes_round(refined.extent, free_.field().origin, context_.gap_px + kWindowMargin_px);
    bring_into_one_period(candidate, free_.grid().period());
    of_sample[docking.sample].push_back(candidate);
  }
  for (std::size_t t = 0; t < samples.size(); ++t) {
    pool_.put(samples[t].id, std::move(of_sample[t]), round.truncated[t]);
  }
}

Window Collage::place(const Candidate& candidate) {
  const Shape& shape = shapes_.shape(candidate.shape);
  placements_.push_back({candidate.shape, candidate.canvas_from_shape, candidate.score, candidate.terms.matched_px});
  outlines_.add(placements_.back(), shape.outline, line_radius(shape.field, shape.perimeter));
  scoring_.count(placements_.back());
  apart_.add(placements_.back());
  covered_px2_ += area_px2(placements_.back());
  const Window changed = free_.stamp(shape, candidate.canvas_from_shape);
  changed_nodes_ = free_.grid().united(changed_nodes_, changed);
  retrace(changed);
  drop_what_is_too_near_to(placements_.back());
  update_limits();
  return piece_window(shape.outline, candidate.canvas_from_shape, free_.field().origin,
                      2 + kept_distance_px(settings_.pieces));
}

Window Collage::replace_placements(std::vector<Placement> placements) {
  const std::vector<Placement> changed = difference(placements_, placements);
  placements_ = std::move(placements);
  outlines_.replace(placements_, shapes_);
  scoring_.forget_placements();
  apart_.forget_placements();
  covered_px2_ = 0;
  for (const Placement& p : placements_) {
    scoring_.count(p);
    apart_.add(p);
    covered_px2_ += area_px2(p);
  }
  pool_ = {};
  checks_.forget_all();
  stale_.clear();
  passes_.clear();
  curve_.set_matched_pads({});
  const Window restamped = restamp(changed);
  changed_nodes_ = free_.grid().united(changed_nodes_, restamped);
  retrace(restamped);
  update_limits();
  Window window;
  for (const Placement& p : changed) {
    window = free_.grid().united(
        window, piece_window(shapes_.shape(p.shape).outline, p.canvas_from_shape, free_.field().origin, 4));
  }
  return window;
}

PoseRange Collage::poses_of(const Placement& p) const {
  for (const Stance& stance : region_stances_.of(region_stances_.list(p.shape))) {
    const PoseRange poses = sized_at(context_, stance, p.canvas_from_shape.translation()).poses;
    if (poses.contains(p.canvas_from_shape) || is_rounded_out_of(poses, p.canvas_from_shape)) return poses;
  }
  const Similarity& pose = p.canvas_from_shape;
  const float scale_px = pose.scale();
  return {scale_px, scale_px, {{pose.a / scale_px, pose.b / scale_px}, {1, 0}}};
}

/// The free field anew in the windows of the pieces that come and go.
Window Collage::restamp(const std::vector<Placement>& changed) {
  Window window;
  for (const Placement& p : changed) window = free_.grid().united(window, stamp_window(p));
  free_.clear(window);
  for (const Placement& p : placements_) {
    for (const Window& common : free_.grid().images(window, stamp_window(p))) {
      free_.stamp(shapes_.shape(p.shape), p.canvas_from_shape, common);
    }
  }
  return window;
}

float Collage::distance_px(const Placement& p, Vec2 point_px) {
  const Vec2 nearest_px = free_.grid().period().nearest(point_px, p.canvas_from_shape.translation());
  return PieceDistance(shapes_.shape(p.shape), p.canvas_from_shape, 0).at(nearest_px);
}

Window Collage::stamp_window(const Placement& p) {
  return free_.stamp_window(shapes_.shape(p.shape), p.canvas_from_shape);
}

void Collage::retrace(const Window& changed) {
  const Window window = opened_.update(free_, changed);
  checks_.forget(window);
  const TargetCurve::Change change = curve_.retrace(opened_, free_.field().origin, window);
  for (const SampleId id : change.removed) {
    pool_.erase(id);
    stale_.erase(id);
  }
  for (const SampleId id : change.renewed) {
    pool_.erase(id);
    if (may_dock(id)) stale_.insert(id);
  }
}

void Collage::drop_what_may_not_stand() {
  const auto may_stand = [&](const Candidate& c) {
    return context_.stances.list(c.shape).count > 0 &&
           c.canvas_from_shape.scale() <= limits_.most_scale_px * (1 + kScaleRounding);
  };
  std::vector<SampleId> ids;
  for (const auto& [id, entry] : pool_.entries()) ids.push_back(id);
  for (const SampleId id : ids) review(id, may_stand);
}

bool Collage::keeps_apart(const Candidate& candidate) {
  return apart_.may_stand(candidate.shape, candidate.canvas_from_shape, candidate.radius);
}

void Collage::drop_what_is_too_near_to(const Placement& placement) {
  if (!apart_.concerns(placement.shape)) return;
  const auto may_stay = [&](const Candidate& c) {
    return !apart_.are_like(c.shape, placement.shape) || keeps_apart(c);
  };
  std::vector<SampleId> ids;
  for (const auto& [id, entry] : pool_.entries()) {
    if (!std::all_of(entry.candidates.begin(), entry.candidates.end(), may_stay)) ids.push_back(id);
  }
  for (const SampleId id : ids) review(id, may_stay);
}

/// Target samples that may have candidates whose windows overlap an image of `changed`.
std::vector<SampleId> Collage::pooled_near(const Window& changed) const {
  const PeriodicGrid& grid = free_.grid();
  if (!grid.period().repeats()) return pool_.reached_by(changed);
  std::set<SampleId> near;
  for (const Window& image : grid.images(changed, grid.nodes())) {
    const std::vector<SampleId> reached = pool_.reached_by(image);
    near.insert(reached.begin(), reached.end());
  }
  return {near.begin(), near.end()};
}

std::vector<Docking> Collage::touched_by(const Window& changed) const {
  std::vector<Docking> touched;
  for (const SampleId id : pooled_near(changed)) {
    for (const Candidate& c : pool_.entries().at(id).candidates) {
      if (!free_.grid().overlap(changed, c.window)) continue;
      touched.push_back({0, c.shape, c.source, c.stance, 0, c.canvas_from_shape});
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
  for (const SampleId id : pooled_near(changed)) {
    review(id, [&](Candidate& c) {
      if (!free_.grid().overlap(changed, c.window)) return true;
      if (measured == terms.end()) throw std::logic_error("fewer candidates were measured than touched");
      c.terms = *measured++;
      if (!scoring_.acceptable(c)) return false;
      c.score = score(c);
      c.exact = false;
      return true;
    });
  }
}

/// A target sample that loses most of its candidates is matched again where there were more.
template <class Keep>
void Collage::review(SampleId id, Keep keep) {
  const bool lost = pool_.review(id, keep);
  const Pool::Entry& entry = pool_.entries().at(id);
  if (lost && entry.candidates.size() < kRefillBelow && entry.truncated) stale_.insert(id);
}

}  // namespace tessera::master
