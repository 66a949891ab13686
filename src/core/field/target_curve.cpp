#include "core/field/target_curve.h"

#include <cmath>

#include "core/pad/pyramid.h"
#include "core/tuning.h"

namespace tessera {
namespace {

/// Where the contour crosses the edge, canvas px.
Vec2 crossing(const Grid<float>& contour, Vec2 origin, const GridEdge& e) {
  const float here = contour(e.x, e.y);
  const float there = e.down ? contour(e.x, e.y + 1) : contour(e.x + 1, e.y);
  const float t = here / (here - there);
  return origin + (e.down ? Vec2{float(e.x), float(e.y) + t} : Vec2{float(e.x) + t, float(e.y)});
}

/// Whether a PAD moved so much that what was matched with the old one no longer holds. Coarse levels may move more:
/// they see far and weigh little.
bool changed_much(const ArclengthPyramid& a, const ArclengthPyramid& b, int levels) {
  if (a.convexity != b.convexity) return true;
  for (int i = 0; i < levels; ++i) {
    const float tolerance = i == levels - 1 ? 0.4f : i == levels - 2 ? 0.25f : 0.15f;
    const float slack_px = 3;
    if (std::abs(a.left[i] - b.left[i]) > tolerance * (b.left[i] + slack_px)) return true;
    if (std::abs(a.right[i] - b.right[i]) > tolerance * (b.right[i] + slack_px)) return true;
  }
  return false;
}

MatchedPad matched_pad(std::uint32_t edge, const ArclengthPyramid& pyramid) {
  return {edge, pyramid.left, pyramid.right, pyramid.convexity};
}

}  // namespace

/// A vertex of the curve, seen smoothed; adds to `support` whatever it visits.
class TargetCurve::Walk {
 public:
  Walk(TargetCurve& curve, int at, TileIndex::Region& support) : curve_(&curve), at_(at), support_(&support) { visit(); }

  Vec2 position() const { return measured(at_).smooth; }
  float turning_rad() const { return measured(at_).turning_rad; }
  float edge_forward() const { return measured(at_).edge_after; }
  float edge_backward() const { return measured(curve_->vertices_[at_].previous).edge_after; }
  void forward() {
    at_ = curve_->vertices_[at_].next;
    visit();
  }
  void backward() {
    at_ = curve_->vertices_[at_].previous;
    visit();
  }
  bool operator==(const Walk& o) const { return at_ == o.at_; }

 private:
  const Vertex& measured(int v) const {
    const Vertex& vertex = curve_->vertices_[v];
    if (!vertex.measured) curve_->measure(v);
    return vertex;
  }

  void visit() { curve_->visit(at_, *support_); }

  TargetCurve* curve_;
  int at_;
  TileIndex::Region* support_;
};

TargetCurve::TargetCurve(const PieceSettings& pieces, const PadParameters& pad)
    : sigma_px_(target_sigma_px(pieces)),
      shortest_loop_px_(kShortestLoop * pieces.min_scale_px),
      spacing_px_(sample_spacing_px(pieces)),
      pad_(pad) {}

std::vector<std::uint32_t> TargetCurve::sample_edges() const {
  std::vector<std::uint32_t> edges;
  edges.reserve(samples_.size());
  for (const auto& [edge, held] : samples_) edges.push_back(edge);
  return edges;
}

std::vector<MatchedPad> TargetCurve::matched_pads() const {
  std::vector<MatchedPad> pads;
  for (const auto& [edge, held] : samples_) {
    const MatchedPad matched = matched_pad(edge, held.matched);
    if (matched != matched_pad(edge, held.sample.pyramid)) pads.push_back(matched);
  }
  return pads;
}

void TargetCurve::set_matched_pads(const std::vector<MatchedPad>& pads) {
  for (auto& [edge, held] : samples_) held.matched = held.sample.pyramid;
  for (const MatchedPad& pad : pads) {
    ArclengthPyramid& matched = samples_.at(pad.edge).matched;
    matched.left = pad.left;
    matched.right = pad.right;
    matched.convexity = pad.convexity;
  }
}

TargetCurve::Change TargetCurve::retrace(const OpenedField& opened, Vec2 origin, const Window& window) {
  const Grid<float>& contour = opened.contour();
  if (width_ == 0) {
    width_ = contour.width();
    vertex_of_edge_ = EdgeTable(width_, contour.height());
  }
  cut_window(window);
  const Window cells =
      Window{window.x0 - 1, window.y0 - 1, window.x1, window.y1}.intersected({0, 0, width_ - 1, contour.height() - 1});
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) trace_cell(contour, origin, x, y);
  }
  forget_smoothing(window);

  Change change;
  for (const std::uint32_t edge : reached_by(window)) {
    const GridEdge e = GridEdge::of(edge, width_);
    const int v = vertex_of_edge_.find(e);
    const auto old = samples_.find(edge);
    const bool reachable = opened.reachable(e.x, e.y) || opened.reachable(e.x + 1, e.y + 1);
    TileIndex::Region support;
    const bool present = v != EdgeTable::kNone && reachable;
    const bool rejected = present && on_short_loop(v, support);
    reject(edge, rejected ? std::move(support).tiles() : std::vector<TileIndex::Tile>());
    if (!present || rejected) {
      if (old == samples_.end()) continue;
      drop(edge);
      change.removed.push_back(edge);
      continue;
    }
    Held held = make_sample(v, std::move(support));
    const bool fresh = old == samples_.end();
    const bool renewed = fresh || changed_much(old->second.matched, held.sample.pyramid, pad_.levels);
    if (!renewed) held.matched = old->second.matched;
    hold(edge, std::move(held));
    if (renewed) change.renewed.push_back(edge);
  }
  return change;
}

/// Where a sample may have to be made (again), or to be dropped: ascending edges.
std::vector<std::uint32_t> TargetCurve::reached_by(const Window& window) const {
  std::vector<std::uint32_t> edges;
  supports_.each(window, [&](std::uint32_t edge) { edges.push_back(edge); });
  vertex_of_edge_.each(window, [&](const GridEdge& e, int) {
    if (on_raster(e)) edges.push_back(e.number(width_));
  });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

void TargetCurve::hold(std::uint32_t edge, Held held) {
  Held& kept = samples_[edge];
  supports_.move(edge, kept.support, held.support);
  kept = std::move(held);
}

void TargetCurve::drop(std::uint32_t edge) {
  const auto found = samples_.find(edge);
  supports_.move(edge, found->second.support, {});
  samples_.erase(found);
}

/// The tiles of the loop that was too short for a sample at this edge; none: it was not.
void TargetCurve::reject(std::uint32_t edge, std::vector<TileIndex::Tile> support) {
  const auto found = rejected_.find(edge);
  if (found == rejected_.end() && support.empty()) return;
  std::vector<TileIndex::Tile>& kept = rejected_[edge];
  supports_.move(edge, kept, support);
  if (support.empty()) {
    rejected_.erase(edge);
  } else {
    kept = std::move(support);
  }
}

int TargetCurve::vertex_at(const GridEdge& edge) {
  const int found = vertex_of_edge_.find(edge);
  if (found != EdgeTable::kNone) return found;
  if (unused_.empty()) {
    unused_.push_back(int(vertices_.size()));
    vertices_.emplace_back();
  }
  const int v = unused_.back();
  unused_.pop_back();
  vertices_[v] = Vertex{};
  vertices_[v].edge = edge;
  vertex_of_edge_.insert(edge, v);
  return v;
}

void TargetCurve::remove_vertex(int v) {
  Vertex& vertex = vertices_[v];
  if (vertex.next >= 0) vertices_[vertex.next].previous = -1;
  if (vertex.previous >= 0) vertices_[vertex.previous].next = -1;
  vertex_of_edge_.erase(vertex.edge);
  vertex.next = vertex.previous = -1;
  unused_.push_back(v);
}

void TargetCurve::cut_window(const Window& window) {
  std::vector<int> inside;
  vertex_of_edge_.each(window, [&](const GridEdge&, int v) { inside.push_back(v); });
  for (const int v : inside) remove_vertex(v);
}

void TargetCurve::trace_cell(const Grid<float>& contour, Vec2 origin, int x, int y) {
  // Corners in the order (x, y), (x+1, y), (x+1, y+1), (x, y+1); edge k joins corners k and k+1.
  const float corner[4] = {contour(x, y), contour(x + 1, y), contour(x + 1, y + 1), contour(x, y + 1)};
  int mask = 0;
  for (int k = 0; k < 4; ++k) {
    if (corner[k] > 0) mask |= 1 << k;  // not (corner[k] > 0) << k: g++ 12 with -fsanitize=undefined miscompiles it
  }
  if (mask == 0 || mask == 15) return;
  const GridEdge edge[4] = {{x, y, false}, {x + 1, y, true}, {x, y + 1, false}, {x, y, true}};
  const auto inside = [&](int k) { return (mask >> (k & 3) & 1) != 0; };
  int leaving[2] = {};
  int entering[2] = {};
  int count = 0;
  int count_in = 0;
  for (int k = 0; k < 4; ++k) {
    if (inside(k) && !inside(k + 1)) leaving[count++] = k;
    if (!inside(k) && inside(k + 1)) entering[count_in++] = k;
  }
  if (count == 1) {
    link(contour, origin, edge[leaving[0]], edge[entering[0]]);
    return;
  }
  // A saddle: the sign of the middle says whether the inside corners are joined.
  const bool joined = corner[0] + corner[1] + corner[2] + corner[3] > 0;
  for (int k = 0; k < 2; ++k) link(contour, origin, edge[leaving[k]], edge[(leaving[k] + (joined ? 1 : 3)) & 3]);
}

void TargetCurve::link(const Grid<float>& contour, Vec2 origin, const GridEdge& from, const GridEdge& to) {
  const int a = vertex_at(from);
  const int b = vertex_at(to);
  vertices_[a].next = b;
  vertices_[b].previous = a;
  vertices_[a].raw = crossing(contour, origin, from);
  vertices_[b].raw = crossing(contour, origin, to);
}

/// Two more than the smoothing reaches: what is measured at a vertex depends on its neighbours' positions.
void TargetCurve::forget_smoothing(const Window& window) {
  vertex_of_edge_.each(window.grown(int(3 * sigma_px_) + 5), [&](const GridEdge&, int v) {
    vertices_[v].smoothed = false;
    vertices_[v].measured = false;
  });
}

Vec2 TargetCurve::smooth_position(int v) {
  Vertex& vertex = vertices_[v];
  if (!vertex.smoothed) {
    vertex.smooth = smoothed_at(v);
    vertex.smoothed = true;
  }
  return vertex.smooth;
}

/// Every walk that passes a vertex asks the same of it.
void TargetCurve::measure(int v) {
  const Vec2 before = smooth_position(vertices_[v].previous);
  const Vec2 here = smooth_position(v);
  const Vec2 after = smooth_position(vertices_[v].next);
  vertices_[v].edge_after = norm(after - here);
  vertices_[v].turning_rad = std::abs(turning_rad(before, here, after));
  vertices_[v].measured = true;
}

/// Gaussian along the arclength; every vertex weighs as much as half of its two edges is long. Summed outwards from v,
/// so that the result does not depend on where the loop starts.
Vec2 TargetCurve::smoothed_at(int v) const {
  const Vertex& centre = vertices_[v];
  const float edge_after = norm(vertices_[centre.next].raw - centre.raw);
  const float edge_before = norm(vertices_[centre.previous].raw - centre.raw);
  float total = 0.5f * (edge_after + edge_before);
  Vec2 sum;
  const auto add_side = [&](int Vertex::*step, float edge) {
    int at = v;
    for (float s = edge; s <= 3 * sigma_px_;) {
      at = vertices_[at].*step;
      if (at == v) return;
      const Vertex& here = vertices_[at];
      const float edge_out = norm(vertices_[here.*step].raw - here.raw);
      const float t = s / sigma_px_;
      const float weight = 0.5f * (edge + edge_out) * std::exp(-0.5f * t * t);
      sum = sum + (here.raw - centre.raw) * weight;
      total += weight;
      edge = edge_out;
      s += edge_out;
    }
  };
  add_side(&Vertex::next, edge_after);
  add_side(&Vertex::previous, edge_before);
  return total > 0 ? centre.raw + sum * (1 / total) : centre.raw;
}

bool TargetCurve::on_short_loop(int v, TileIndex::Region& support) const {
  float length = 0;
  int at = v;
  do {
    visit(at, support);
    const int next = vertices_[at].next;
    length += norm(vertices_[next].raw - vertices_[at].raw);
    at = next;
  } while (at != v && length < shortest_loop_px_);
  return length < shortest_loop_px_;
}

/// A smoothed position depends on what lies up to three sigma along the curve.
void TargetCurve::visit(int v, TileIndex::Region& support) const {
  const GridEdge& e = vertices_[v].edge;
  support.add(Window{e.x, e.y, e.x + 2, e.y + 2}.grown(int(3 * sigma_px_) + 3));
}

TargetCurve::Held TargetCurve::make_sample(int v, TileIndex::Region support) {
  Held held;
  const GridEdge& e = vertices_[v].edge;
  held.sample.edge = e.number(width_);
  held.sample.position = vertices_[v].raw;
  held.sample.pyramid = make_pyramid(Walk(*this, v, support), pad_, curvature_dead_zone(sigma_px_));
  const auto& key = held.sample.pyramid.keypoint;
  const Vec2 chord = key[pad_.levels + 1] - key[pad_.levels - 1];
  held.sample.tangent = chord * (1 / std::max(norm(chord), 1e-6f));
  held.matched = held.sample.pyramid;
  held.support = std::move(support).tiles();
  return held;
}

}  // namespace tessera
