#include "master/collage.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <tuple>

#include "core/field/piece_distance.h"
#include "core/geometry/extent.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_field.h"
#include "master/rules/acceptance.h"

namespace tessera::master {
namespace {

double area_px2(const Placement& p) {
  const float scale = p.canvas_from_shape.scale();
  return double(scale) * scale;
}

/// Whether the piece fits into one period. A longer piece would reach its own image.
bool fits_into(const Period& period, const Extent& piece) {
  const Vec2 size = piece.high - piece.low;
  return (period.x_px == 0 || size.x <= float(period.x_px)) && (period.y_px == 0 || size.y <= float(period.y_px));
}

/// Moves the candidate to the image whose centre lies in the first period; it stands for all images.
void bring_into_one_period(Candidate& candidate, const Period& period) {
  const Vec2 found = candidate.canvas_from_shape.translation();
  candidate.canvas_from_shape = period.wrapped(candidate.canvas_from_shape);
  const Vec2 by = candidate.canvas_from_shape.translation() - found;
  const int dx = int(std::lround(by.x));
  const int dy = int(std::lround(by.y));
  Window& window = candidate.window;
  window = {window.x0 + dx, window.y0 + dy, window.x1 + dx, window.y1 + dy};
}

/// The symmetric difference of both lists.
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
      shapes_(shapes),
      free_(canvas, settings.pieces),
      opened_(free_, settings.pieces),
      curve_(settings.pieces, settings.match.pad),
      outlines_(free_, settings.pieces),
      scoring_(settings, context.stances, silhouettes_of(shapes, context.library_shapes), canvas.period,
               drawings_of(shapes, context.library_shapes)),
      open_shapes_(context, settings.pieces, scoring_, shapes, size_factor),
      apart_(settings, shapes, canvas.period),
      settling_(free_, outlines_, open_shapes_.context()),
      checks_(shapes, free_, opened_, settling_, settings_.pieces, open_shapes_.context()),
      schedule_(free_, curve_, growth_),
      batch_(free_.grid(), settings_) {
  note_changed(free_.field().value.bounds());
  retrace({free_.field().value.bounds()});
  update_open_shapes();
}

void Collage::begin(std::vector<Placement> standing, std::size_t given, std::uint32_t region) {
  open_shapes_.begin(region, given);
  replace_placements(std::move(standing));
  schedule_.mark(free_.field().value.bounds());
}

/// The shapes that find no place, because of the distances that pieces keep from their like.
std::vector<ShapeId> Collage::shut_out_shapes() const {
  if (!apart_.matters()) return {};
  return apart_.shut_out(context().library_shapes, [this](const auto& holds) { return curve_.any_position(holds); });
}

/// Updates the open shapes, which follow from the placements alone, and drops candidates that may no longer stand. It
/// looks at the whole library, so within a batch only jobs that limit uses call it.
void Collage::update_open_shapes() {
  if (!scoring_.limits_uses() && !apart_.matters()) return;
  if (!open_shapes_.update(shut_out_shapes(), double(free_.free_256ths_px2()) / 256)) return;
  std::vector<SampleId> ids;
  for (const auto& [id, entry] : pool_.entries()) ids.push_back(id);
  for (const SampleId id : ids) review(id, [this](const Candidate& c) { return open_shapes_.allows(c); });
}

std::vector<Window> Collage::take_changed_nodes() { return std::exchange(changed_nodes_, {}); }

/// Notes nodes for take_changed_nodes(). Once the list is longer than the field, the field itself stands for all of it.
void Collage::note_changed(const Window& nodes) {
  const Window whole = free_.field().value.bounds();
  const auto area = [](const Window& w) { return std::int64_t(w.width()) * w.height(); };
  changed_nodes_.push_back(nodes);
  std::int64_t sum = 0;
  for (const Window& w : changed_nodes_) sum += area(w);
  if (sum > area(whole)) changed_nodes_ = {whole};
}

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
    if (!scoring_.may_use(docking.shape) || !acceptable(candidate) || !keeps_apart(candidate)) continue;
    if (!fits_into(free_.grid().period(), refined.extent)) continue;
    candidate.score = score(candidate);
    candidate.window = nodes_round(refined.extent, free_.field().origin, context().gap_px + kWindowMargin_px);
    bring_into_one_period(candidate, free_.grid().period());
    of_sample[docking.sample].push_back(candidate);
  }
  for (std::size_t t = 0; t < samples.size(); ++t) {
    pool_.put(samples[t].id, std::move(of_sample[t]), round.truncated[t]);
  }
}

void Collage::place(const Candidate& candidate) {
  const float worth_now = worth(candidate);
  placements_.push_back({candidate.shape, candidate.canvas_from_shape, candidate.score, candidate.terms.matched_px});
  add_to_batch(placements_.back(), worth_now);
  drop_candidates_near(placements_.back());
  if (scoring_.limits_uses()) update_open_shapes();
}

/// Adds the piece to what stands, but for the target curve, which merge_batch() brings up to date.
void Collage::add_to_batch(const Placement& piece, float worth) {
  const Shape& shape = shapes_.shape(piece.shape);
  outlines_.add(piece, shape.outline, line_radius(shape.field, shape.perimeter));
  scoring_.count(piece);
  apart_.add(piece);
  covered_px2_ += area_px2(piece);
  const Window stamped = free_.stamp(shape, piece.canvas_from_shape);
  note_changed(stamped);
  checks_.forget_near(shape, piece.canvas_from_shape, stamped);
  batch_.add(touched_window(shape, piece.canvas_from_shape), stamped, worth);
}

void Collage::merge_batch() { retrace(batch_.stamped()); }

/// The nodes within which a piece changes the terms of candidates.
Window Collage::touched_window(const Shape& shape, const Similarity& canvas_from_shape) const {
  return piece_window(shape.outline, canvas_from_shape, free_.field().origin, 2 + kept_distance_px(settings_.pieces));
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
  schedule_.clear();
  curve_.set_matched_pads({});
  std::vector<Window> renewed = batch_.stamped();
  renewed.push_back(restamp(changed));
  batch_.end();
  note_changed(renewed.back());
  retrace(renewed);
  update_open_shapes();
  Window window;
  for (const Placement& p : changed) {
    window = free_.grid().united(
        window, piece_window(shapes_.shape(p.shape).outline, p.canvas_from_shape, free_.field().origin, 4));
  }
  return window;
}

/// Computes the free field again in the windows of pieces that come and go.
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

/// Brings opened field, target curve, pool and schedule up to date with these nodes of the free field.
void Collage::retrace(const std::vector<Window>& changed) {
  const std::vector<Window> windows = opened_.update(free_, changed);
  for (const Window& window : windows) checks_.forget(window);
  const TargetCurve::Change change = curve_.retrace(opened_, free_.field().origin, windows);
  for (const SampleId id : change.removed) pool_.erase(id);
  for (const SampleId id : change.renewed) pool_.erase(id);
  schedule_.follow(change);
}

bool Collage::keeps_apart(const Candidate& candidate) {
  return apart_.may_stand(candidate.shape, candidate.canvas_from_shape, candidate.radius);
}

/// Drops candidates that are too near to the placed piece, which is their like.
void Collage::drop_candidates_near(const Placement& placement) {
  if (!apart_.concerns(placement.shape)) return;
  const int reach = int(std::ceil(apart_.distance_px(placement.shape)));
  const Window near = touched_window(shapes_.shape(placement.shape), placement.canvas_from_shape).grown(reach);
  for (const SampleId id : pooled_near({near}))
    review(id, [&](const Candidate& c) { return !apart_.are_like(c.shape, placement.shape) || keeps_apart(c); });
}

/// The target samples that may have candidates whose windows overlap images of these windows.
/// Ascending, each once.
std::vector<SampleId> Collage::pooled_near(const std::vector<Window>& windows) const {
  const PeriodicGrid& grid = free_.grid();
  const bool repeats = grid.period().repeats();
  std::vector<SampleId> near;
  for (const Window& window : windows) {
    for (const Window& image : repeats ? grid.images(window, grid.nodes()) : std::vector{window}) {
      const std::vector<SampleId> reached = pool_.reached_by(image);
      near.insert(near.end(), reached.begin(), reached.end());
    }
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

std::vector<Docking> Collage::touched() const {
  std::vector<Docking> touched;
  for (const SampleId id : pooled_near(batch_.touched())) {
    for (const Candidate& c : pool_.entries().at(id).candidates) {
      if (batch_.touches(c.window)) touched.push_back({0, c.shape, c.source, c.stance, 0, c.canvas_from_shape});
    }
  }
  return touched;
}

std::vector<DockingTerms> Collage::measure(const std::vector<Docking>& dockings) {
  std::vector<DockingTerms> terms;
  for (const Docking& docking : dockings) {
    terms.push_back(docking_terms(docking.canvas_from_shape, shapes_.model(docking.shape), free_.view(), context()));
  }
  return terms;
}

void Collage::end_batch(const std::vector<DockingTerms>& terms) {
  auto measured = terms.begin();
  for (const SampleId id : pooled_near(batch_.touched())) {
    review(id, [&](Candidate& c) {
      if (!batch_.touches(c.window)) return true;
      if (measured == terms.end()) throw std::logic_error("fewer candidates were measured than touched");
      c.terms = *measured++;
      if (!acceptable(c)) return false;
      c.score = score(c);
      c.exact = false;
      return true;
    });
  }
  batch_.end();
  pool_.bring_back();
  update_open_shapes();
}

/// Drops the candidates of a sample that `keep` refuses. Where few are left and matching had found more, the sample is
/// matched again.
template <class Keep>
void Collage::review(SampleId id, Keep keep) {
  const bool lost = pool_.review(id, keep);
  const Pool::Entry& entry = pool_.entries().at(id);
  if (lost && entry.candidates.size() < kRefillBelow && entry.truncated) schedule_.mark(id);
}

}  // namespace tessera::master
