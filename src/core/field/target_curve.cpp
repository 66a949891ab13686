#include "core/field/target_curve.h"

#include <algorithm>
#include <cmath>

#include "core/base/rank_pool.h"
#include "core/pad/pyramid.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

/// Whether a PAD changed so much that results of matching the old one are no longer valid.
bool changed_much(const ArclengthPyramid& a, const ArclengthPyramid& b, int levels) {
  if (a.convexity != b.convexity) return true;
  for (int i = 0; i < levels; ++i) {
    const float tolerance = i == levels - 1 ? kChangedCoarsest : i == levels - 2 ? kChangedCoarse : kChangedFine;
    if (std::abs(a.left[i] - b.left[i]) > tolerance * (b.left[i] + kChangedSlack_px)) return true;
    if (std::abs(a.right[i] - b.right[i]) > tolerance * (b.right[i] + kChangedSlack_px)) return true;
  }
  return false;
}

MatchedPad matched_pad(SampleId id, const ArclengthPyramid& pyramid) {
  return {id, pyramid.left, pyramid.right, pyramid.convexity};
}

}  // namespace

/// A walk over the smoothed vertices of the curve; adds everything it visits to `support`.
class TargetCurve::Walk {
 public:
  Walk(const TargetCurve& curve, int at, TileIndex::Region& support) : curve_(&curve), at_(at), support_(&support) {
    visit();
  }

  /// The position; it continues beyond the period with the curve.
  Vec2 position() const { return here().smooth + beyond_px_; }
  float turning_rad() const { return here().turning_rad; }
  float edge_forward() const { return here().edge_after; }
  float edge_backward() const { return curve_->contour_.vertex(here().previous).edge_after; }
  void forward() { go(curve_->contour_.vertex(at_).next); }
  void backward() { go(curve_->contour_.vertex(at_).previous); }
  bool operator==(const Walk& o) const { return at_ == o.at_; }

 private:
  const LinkedContour::Vertex& here() const { return curve_->contour_.vertex(at_); }
  void visit() { curve_->visit(at_, *support_); }
  void go(int to) {
    const Period& period = curve_->contour_.grid().period();
    if (period.repeats()) {  // without this test 1 % of a run's time on other canvases
      const Vec2 next = curve_->contour_.vertex(to).smooth;
      beyond_px_ = beyond_px_ + (period.nearest(next, here().smooth) - next);
    }
    at_ = to;
    visit();
  }

  const TargetCurve* curve_;
  int at_;
  TileIndex::Region* support_;
  Vec2 beyond_px_;  // whole periods since the walk began
};

TargetCurve::TargetCurve(const PieceSettings& pieces, const PadParameters& pad)
    : contour_(target_sigma_px(pieces)),
      sigma_px_(target_sigma_px(pieces)),
      shortest_loop_px_(kShortestLoop * pieces.min_scale_px),
      longest_side_px_(kLongestSide * pieces.max_scale_px),
      spacing_px_(sample_spacing_px(pieces)),
      pad_(pad) {}

std::vector<SampleId> TargetCurve::samples() const {
  std::vector<SampleId> ids;
  ids.reserve(samples_.size());
  for (const auto& [id, held] : samples_) ids.push_back(id);
  return ids;
}

std::vector<MatchedPad> TargetCurve::matched_pads() const {
  std::vector<MatchedPad> pads;
  for (const auto& [id, held] : samples_) {
    const MatchedPad matched = matched_pad(id, held.matched);
    if (matched != matched_pad(id, held.sample.pyramid)) pads.push_back(matched);
  }
  return pads;
}

void TargetCurve::set_matched_pads(const std::vector<MatchedPad>& pads) {
  for (auto& [id, held] : samples_) held.matched = held.sample.pyramid;
  for (const MatchedPad& pad : pads) {
    ArclengthPyramid& matched = samples_.at(pad.sample).matched;
    matched.left = pad.left;
    matched.right = pad.right;
    matched.convexity = pad.convexity;
  }
}

TargetCurve::Change TargetCurve::retrace(const OpenedField& opened, Vec2 origin, const std::vector<Window>& windows) {
  constexpr std::size_t kPortion = 8;
  contour_.retrace(opened.contour(), opened.grid(), origin, windows);
  const std::vector<SampleId> reached = reached_by(windows);
  std::vector<Place> places(reached.size());
  parallel_for_portions(reached.size(), kPortion, [&](std::size_t i) { places[i] = look_at(reached[i], opened); });
  Change change;
  for (std::size_t i = 0; i < reached.size(); ++i) renew(reached[i], std::move(places[i]), change);
  return change;
}

TargetCurve::Place TargetCurve::look_at(SampleId id, const OpenedField& opened) const {
  const GridEdge e = GridEdge::of(edge_number(id), contour_.width());
  const int v = contour_.find(e);
  const bool reachable = opened.reachable(e.x, e.y) || opened.reachable(e.x + 1, e.y + 1);
  Place place;
  if (v == LinkedContour::kNone || !reachable) return place;
  TileIndex::Region support;
  if (on_short_loop(v, support)) {
    place.kind = Place::Kind::short_loop;
    place.entry.support = std::move(support).tiles();
  } else {
    place.kind = Place::Kind::sample;
    place.entry = make_sample(v, std::move(support));
  }
  return place;
}

/// Holds, keeps or drops the sample, by what is at its place now.
void TargetCurve::renew(SampleId id, Place place, Change& change) {
  const bool short_loop = place.kind == Place::Kind::short_loop;
  reject(id, short_loop ? std::move(place.entry.support) : std::vector<TileIndex::Tile>());
  const auto old = samples_.find(id);
  if (place.kind != Place::Kind::sample) {
    if (old == samples_.end()) return;
    drop(id);
    change.removed.push_back(id);
    return;
  }
  const bool fresh = old == samples_.end();
  const bool renewed = fresh || changed_much(old->second.matched, place.entry.sample.pyramid, pad_.levels);
  if (!renewed) place.entry.matched = old->second.matched;
  hold(id, std::move(place.entry));
  if (renewed) change.renewed.push_back(id);
}

/// Samples that may have to be made, made again or dropped: ascending.
std::vector<SampleId> TargetCurve::reached_by(const std::vector<Window>& windows) const {
  std::vector<SampleId> ids;
  const PeriodicGrid& grid = contour_.grid();
  for (const Window& window : windows) {
    for (const Window& part : grid.images(window, grid.one_period().grown(support_nodes()))) {
      supports_.each(part, [&](std::uint32_t thing) { ids.push_back(SampleId{thing}); });
    }
    contour_.each(window, [&](const GridEdge& e, int) {
      if (on_raster(e)) ids.push_back(SampleId{e.number(contour_.width())});
    });
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

void TargetCurve::hold(SampleId id, SampleEntry held) {
  SampleEntry& kept = samples_[id];
  supports_.move(edge_number(id), kept.support, held.support);
  kept = std::move(held);
}

void TargetCurve::drop(SampleId id) {
  const auto found = samples_.find(id);
  supports_.move(edge_number(id), found->second.support, {});
  samples_.erase(found);
}

/// Notes the tiles of the loop that is too short for a sample here; empty: the loop is not too short.
void TargetCurve::reject(SampleId id, std::vector<TileIndex::Tile> support) {
  const auto found = rejected_.find(id);
  if (found == rejected_.end() && support.empty()) return;
  std::vector<TileIndex::Tile>& kept = rejected_[id];
  supports_.move(edge_number(id), kept, support);
  if (support.empty()) {
    rejected_.erase(id);
  } else {
    kept = std::move(support);
  }
}

bool TargetCurve::on_short_loop(int v, TileIndex::Region& support) const {
  float length = 0;
  int at = v;
  do {
    visit(at, support);
    const int next = contour_.vertex(at).next;
    length += contour_.length_px(at, next);
    at = next;
  } while (at != v && length < shortest_loop_px_);
  return length < shortest_loop_px_;
}

void TargetCurve::visit(int v, TileIndex::Region& support) const {
  const GridEdge& e = contour_.vertex(v).edge;
  support.add(Window{e.x, e.y, e.x + 2, e.y + 2}.grown(support_nodes()));
}

TargetCurve::SampleEntry TargetCurve::make_sample(int v, TileIndex::Region support) const {
  SampleEntry held;
  const GridEdge& e = contour_.vertex(v).edge;
  held.sample.id = SampleId{e.number(contour_.width())};
  held.sample.position = contour_.vertex(v).raw;
  held.sample.pyramid = make_pyramid(Walk(*this, v, support), pad_, curvature_dead_zone(sigma_px_), longest_side_px_);
  const auto& key = held.sample.pyramid.keypoint;
  const Vec2 chord = key[pad_.levels + 1] - key[pad_.levels - 1];
  held.sample.tangent = chord * (1 / std::max(norm(chord), 1e-6f));
  held.matched = held.sample.pyramid;
  held.support = std::move(support).tiles();
  return held;
}

}  // namespace tessera
