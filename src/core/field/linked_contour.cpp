#include "core/field/linked_contour.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/rank_pool.h"
#include "core/geometry/bit_grid.h"
#include "core/pad/pyramid.h"

namespace tessera {
namespace {

/// The point where the contour crosses the edge, canvas px.
Vec2 crossing(const Grid<float>& contour, Vec2 origin, const GridEdge& e) {
  const float here = contour(e.x, e.y);
  const float there = e.down ? contour(e.x, e.y + 1) : contour(e.x + 1, e.y);
  const float t = here / (here - there);
  return origin + (e.down ? Vec2{float(e.x), float(e.y) + t} : Vec2{float(e.x) + t, float(e.y)});
}

/// Calls f(x, y), row by row, for each cell of which some corners lie above 0 and some do not. Few cells do.
template <class F>
void each_crossed(const Grid<float>& contour, const Window& cells, F f) {
  if (cells.empty()) return;
  const BitGrid above = nodes_above(contour, {cells.x0, cells.y0, cells.x1 + 1, cells.y1 + 1}, 0);
  const auto next = [&](const std::uint64_t* row, int k) {
    return row[k] >> 1 | (k + 1 < above.words() ? row[k + 1] << 63 : 0);
  };
  for (int y = 0; y < cells.height(); ++y) {
    const std::uint64_t* upper = above.row(y);
    const std::uint64_t* lower = above.row(y + 1);
    for (int k = 0; k < above.words(); ++k) {
      const std::uint64_t any = upper[k] | lower[k] | next(upper, k) | next(lower, k);
      const std::uint64_t all = upper[k] & lower[k] & next(upper, k) & next(lower, k);
      for (std::uint64_t crossed = any & ~all; crossed != 0; crossed &= crossed - 1) {
        const int x = 64 * k + std::countr_zero(crossed);
        if (x < cells.width()) f(cells.x0 + x, cells.y0 + y);
      }
    }
  }
}

}  // namespace

void LinkedContour::retrace(const Grid<float>& contour, const PeriodicGrid& grid, Vec2 origin,
                            const std::vector<Window>& windows) {
  if (width_ == 0) {
    grid_ = grid;
    width_ = contour.width();
    vertex_of_edge_ = EdgeTable(width_, contour.height());
  }
  const Window known = grid_.with_next_nodes();
  const Window all_cells{known.x0, known.y0, known.x1 - 1, known.y1 - 1};
  for (const Window& window : windows) {
    cut_window(window);
    for (const Window& cells : grid_.images({window.x0 - 1, window.y0 - 1, window.x1, window.y1}, all_cells)) {
      each_crossed(contour, cells, [&](int x, int y) { trace_cell(contour, origin, x, y); });
    }
  }
  smooth(windows);
}

GridEdge LinkedContour::in_one_period(const GridEdge& edge) const {
  return {grid_.column(edge.x), grid_.row(edge.y), edge.down};
}

int LinkedContour::vertex_at(const GridEdge& edge) {
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

void LinkedContour::remove_vertex(int v) {
  Vertex& vertex = vertices_[v];
  if (vertex.next >= 0) vertices_[vertex.next].previous = -1;
  if (vertex.previous >= 0) vertices_[vertex.previous].next = -1;
  vertex_of_edge_.erase(vertex.edge);
  vertex.next = vertex.previous = -1;
  unused_.push_back(v);
}

void LinkedContour::cut_window(const Window& window) {
  for (const int v : vertices_in({window})) remove_vertex(v);
}

/// Each vertex once, although an edge may touch several windows.
std::vector<int> LinkedContour::vertices_in(const std::vector<Window>& windows) const {
  std::vector<int> inside;
  for (const Window& window : windows) {
    each(window, [&](const GridEdge&, int v) { inside.push_back(v); });
  }
  std::sort(inside.begin(), inside.end());
  inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
  return inside;
}

void LinkedContour::trace_cell(const Grid<float>& contour, Vec2 origin, int x, int y) {
  // Corners in the order (x, y), (x+1, y), (x+1, y+1), (x, y+1); edge k joins corners k and k+1.
  const float corner[4] = {contour(x, y), contour(x + 1, y), contour(x + 1, y + 1), contour(x, y + 1)};
  int mask = 0;
  for (int k = 0; k < 4; ++k) {
    if (corner[k] > 0) mask |= 1 << k;  // not (corner[k] > 0) << k: g++ 12 with -fsanitize=undefined miscompiles it
  }
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
  // A saddle: the sign of the middle tells whether the inside corners are joined.
  const bool joined = corner[0] + corner[1] + corner[2] + corner[3] > 0;
  for (int k = 0; k < 2; ++k) link(contour, origin, edge[leaving[k]], edge[(leaving[k] + (joined ? 1 : 3)) & 3]);
}

void LinkedContour::link(const Grid<float>& contour, Vec2 origin, const GridEdge& from, const GridEdge& to) {
  const GridEdge edge_a = in_one_period(from);
  const GridEdge edge_b = in_one_period(to);
  const int a = vertex_at(edge_a);
  const int b = vertex_at(edge_b);
  vertices_[a].next = b;
  vertices_[b].previous = a;
  vertices_[a].raw = crossing(contour, origin, edge_a);
  vertices_[b].raw = crossing(contour, origin, edge_b);
}

/// Smooths the line around the windows. The margin is two more than the reach of the smoothing: values of a vertex also
/// depend on its neighbours' positions.
void LinkedContour::smooth(const std::vector<Window>& windows) {
  constexpr std::size_t kPortion = 256;
  std::vector<Window> reached;
  for (const Window& window : windows) reached.push_back(window.grown(int(3 * sigma_px_) + 5));
  const std::vector<int> changed = vertices_in(reached);
  parallel_for_portions(changed.size(), kPortion,
                        [&](std::size_t i) { vertices_[changed[i]].smooth = smoothed_at(changed[i]); });
  parallel_for_portions(changed.size(), kPortion, [&](std::size_t i) { measure(changed[i]); });
}

void LinkedContour::measure(int v) {
  Vertex& vertex = vertices_[v];
  const Vec2 here = vertex.smooth;
  const Vec2 before = grid_.period().nearest(vertices_[vertex.previous].smooth, here);
  const Vec2 after = grid_.period().nearest(vertices_[vertex.next].smooth, here);
  vertex.edge_after = norm(after - here);
  vertex.turning_rad = std::abs(turning_rad(before, here, after));
}

float LinkedContour::length_px(int from, int to) const {
  const Vec2 begin = vertices_[from].raw;
  return norm(grid_.period().nearest(vertices_[to].raw, begin) - begin);
}

/// Gaussian along the arclength; each vertex weighs half the length of its two edges. Summed outwards from v, so that
/// the result does not depend on the start of the loop.
Vec2 LinkedContour::smoothed_at(int v) const {
  const Vertex& centre = vertices_[v];
  const float edge_after = length_px(v, centre.next);
  const float edge_before = length_px(v, centre.previous);
  float total = 0.5f * (edge_after + edge_before);
  Vec2 sum;
  const auto add_side = [&](int Vertex::*step, float edge) {
    int at = v;
    for (float s = edge; s <= 3 * sigma_px_;) {
      at = vertices_[at].*step;
      if (at == v) return;
      const Vertex& here = vertices_[at];
      const float edge_out = length_px(at, here.*step);
      const float t = s / sigma_px_;
      const float weight = 0.5f * (edge + edge_out) * std::exp(-0.5f * t * t);
      sum = sum + (grid_.period().nearest(here.raw, centre.raw) - centre.raw) * weight;
      total += weight;
      edge = edge_out;
      s += edge_out;
    }
  };
  add_side(&Vertex::next, edge_after);
  add_side(&Vertex::previous, edge_before);
  return total > 0 ? centre.raw + sum * (1 / total) : centre.raw;
}

}  // namespace tessera
