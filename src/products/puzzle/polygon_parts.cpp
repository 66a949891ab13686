#include "products/puzzle/polygon_parts.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "core/geometry/polygon.h"

namespace tessera {
namespace {

using Curve = std::vector<Vec2>;

bool before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

struct Before {
  bool operator()(Vec2 a, Vec2 b) const { return before(a, b); }
};

/// On which side of the line from p to q the point lies: twice the triangle's area. For floats the sign is exact.
double side(Vec2 p, Vec2 q, Vec2 r) {
  return (double(q.x) - p.x) * (double(r.y) - p.y) - (double(q.y) - p.y) * (double(r.x) - p.x);
}

/// A crossing of an edge of the cell and an edge of the outline.
struct Crossing {
  std::size_t cell_edge, outline_edge;
  double along_cell, along_outline;  // parts of the edges
  Vec2 at;
  bool enters;  // the cell's boundary enters the outline here
  std::size_t next_on_cell = 0, next_on_outline = 0;
};

/// The cell's edge is always taken from the same end, for both cells beside it.
void find_crossing(const Curve& cell, std::size_t i, const Curve& outline, std::size_t j, std::vector<Crossing>& all) {
  const Vec2 from = cell[i], to = cell[(i + 1) % cell.size()];
  const bool turned = before(to, from);
  const Vec2 p = turned ? to : from, q = turned ? from : to;
  const Vec2 r = outline[j], s = outline[(j + 1) % outline.size()];
  if (std::max(p.x, q.x) < std::min(r.x, s.x) || std::max(r.x, s.x) < std::min(p.x, q.x)) return;
  const double r_side = side(p, q, r), s_side = side(p, q, s), p_side = side(r, s, p), q_side = side(r, s, q);
  if ((r_side > 0) == (s_side > 0) || (p_side > 0) == (q_side > 0)) return;
  const double along_outline = r_side / (r_side - s_side), along = p_side / (p_side - q_side);
  const Vec2 at{float(r.x + (double(s.x) - r.x) * along_outline), float(r.y + (double(s.y) - r.y) * along_outline)};
  const bool enters = (turned ? p_side : q_side) > 0;
  all.push_back({i, j, turned ? 1 - along : along, along_outline, at, enters});
}

std::vector<Crossing> crossings(const Curve& cell, const Curve& outline) {
  const Box box = bounding_box(cell);
  std::vector<Crossing> all;
  for (std::size_t j = 0; j < outline.size(); ++j) {
    const Vec2 r = outline[j], s = outline[(j + 1) % outline.size()];
    if (!within_reach(bounding_box(Curve{r, s}), box, 0)) continue;
    for (std::size_t i = 0; i < cell.size(); ++i) find_crossing(cell, i, outline, j, all);
  }
  return all;
}

/// Links each crossing to the next one along either boundary.
void link(std::vector<Crossing>& all) {
  std::vector<std::size_t> order(all.size());
  const auto link_by = [&](auto place, auto next) {
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place(all[a]) < place(all[b]); });
    for (std::size_t k = 0; k < order.size(); ++k) all[order[k]].*next = order[(k + 1) % order.size()];
  };
  link_by([](const Crossing& c) { return std::pair(c.cell_edge, c.along_cell); }, &Crossing::next_on_cell);
  link_by([](const Crossing& c) { return std::pair(c.outline_edge, c.along_outline); }, &Crossing::next_on_outline);
}

/// Appends the points of a curve after an edge's start, up to the start of another edge. Goes all the way round where the
/// place on the same edge is not farther on.
void append_between(const Curve& curve, std::size_t edge, std::size_t last_edge, bool round, Curve& part) {
  std::size_t steps = (last_edge + curve.size() - edge) % curve.size();
  if (steps == 0 && round) steps = curve.size();
  for (std::size_t k = 1; k <= steps; ++k) part.push_back(curve[(edge + k) % curve.size()]);
}

/// The curve without points that repeat the one before.
Curve without_repeats(Curve part) {
  part.erase(std::unique(part.begin(), part.end()), part.end());
  while (part.size() > 1 && part.front() == part.back()) part.pop_back();
  return part;
}

Curve part_from(std::size_t first, const Curve& cell, const Curve& outline, std::vector<Crossing>& all,
                std::vector<bool>& seen) {
  Curve part;
  std::size_t at = first;
  do {
    seen[at] = true;
    const Crossing& in = all[at];
    const Crossing& out = all[in.next_on_cell];
    part.push_back(in.at);
    append_between(cell, in.cell_edge, out.cell_edge, out.along_cell <= in.along_cell, part);
    part.push_back(out.at);
    at = out.next_on_outline;
    const Crossing& back = all[at];
    append_between(outline, out.outline_edge, back.outline_edge, back.along_outline <= out.along_outline, part);
  } while (!seen[at]);
  return without_repeats(std::move(part));
}

using Edge = std::pair<Vec2, Vec2>;

struct EdgeBefore {
  bool operator()(const Edge& a, const Edge& b) const {
    return a.first == b.first ? before(a.second, b.second) : before(a.first, b.first);
  }
};

using Edges = std::set<Edge, EdgeBefore>;

Edges edges_of(const Curve& curve) {
  Edges edges;
  for (std::size_t k = 0; k < curve.size(); ++k) edges.insert({curve[k], curve[(k + 1) % curve.size()]});
  return edges;
}

}  // namespace

std::vector<Curve> common_parts(const Curve& cell, const Curve& outline) {
  std::vector<Crossing> all = crossings(cell, outline);
  if (all.empty()) {
    if (contains(outline, cell.front())) return {cell};
    if (contains(cell, outline.front())) return {outline};
    return {};
  }
  link(all);
  std::vector<bool> seen(all.size());
  std::vector<Curve> parts;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!all[k].enters || seen[k]) continue;
    Curve part = part_from(k, cell, outline, all, seen);
    if (part.size() >= 3 && signed_area(part) > 0) parts.push_back(std::move(part));
  }
  return parts;
}

double shared_length(const Curve& a, const Curve& b) {
  const Edges edges = edges_of(b);
  double length = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Vec2 from = a[k], to = a[(k + 1) % a.size()];
    if (edges.contains({to, from})) length += norm(to - from);
  }
  return length;
}

std::optional<Curve> joined(const Curve& a, const Curve& b) {
  const Edges of_a = edges_of(a), of_b = edges_of(b);
  std::map<Vec2, Vec2, Before> next;
  std::size_t kept = 0;
  const auto take = [&](const Edges& edges, const Edges& others) {
    for (const Edge& edge : edges) {
      if (others.contains({edge.second, edge.first})) continue;
      next[edge.first] = edge.second;
      ++kept;
    }
  };
  take(of_a, of_b);
  take(of_b, of_a);
  if (kept == a.size() + b.size() || next.empty()) return {};
  Curve curve;
  Vec2 at = next.begin()->first;
  do {
    curve.push_back(at);
    const auto on = next.find(at);
    if (on == next.end()) return {};
    at = on->second;
  } while (!(at == curve.front()) && curve.size() <= kept);
  if (curve.size() != kept) return {};  // a hole, or a point in which they touch as well
  return curve;
}

}  // namespace tessera
