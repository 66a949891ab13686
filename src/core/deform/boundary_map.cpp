#include "core/deform/boundary_map.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

constexpr float kCell_px = 4;  // a neighbour mostly lies within this distance
constexpr double kMostCells = 1 << 24;
constexpr float kSelf_px = 0.1f;

struct Extents {
  Vec2 low{INFINITY, INFINITY};
  Vec2 high{-INFINITY, -INFINITY};
};

/// The distance along the ray at which it crosses the segment; negative: it does not.
float crossing(Vec2 from, Vec2 direction, const Segment& segment) {
  const Vec2 side = segment.to - segment.from;
  const float turn = cross(direction, side);
  if (turn == 0) return -1;
  const Vec2 away = segment.from - from;
  const float along_side = cross(away, direction) / turn;
  return along_side >= 0 && along_side <= 1 ? cross(away, side) / turn : -1;
}

bool cross_each_other(const Segment& a, const Segment& b) {
  const auto side_of = [](const Segment& s, Vec2 p) { return cross(s.to - s.from, p - s.from); };
  return (side_of(a, b.from) > 0) != (side_of(a, b.to) > 0) && (side_of(b, a.from) > 0) != (side_of(b, a.to) > 0);
}

}  // namespace

BoundaryMap::BoundaryMap(const std::vector<Outline>& pieces_px, const Period& period) {
  const std::vector<Vec2> offsets = period.offsets();
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    for (std::uint32_t piece = 0; piece < pieces_px.size(); ++piece) {
      if (k == 0) own_sides_.push_back(std::uint32_t(sides_.size()));
      add(pieces_px[piece], piece, offsets[k], k > 0);
    }
    if (k == 0) own_sides_.push_back(std::uint32_t(sides_.size()));
  }
  sort_into_cells();
}

void BoundaryMap::add(const Outline& outline, std::uint32_t piece, Vec2 offset, bool image) {
  for (const std::vector<Vec2>& curve : outline.curves) {
    const std::uint32_t begin = std::uint32_t(sides_.size()), count = std::uint32_t(curve.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t next = i + 1 == count ? 0 : i + 1;
      sides_.push_back(
          {{curve[i] + offset, curve[next] + offset}, piece, image, begin + (i + count - 1) % count, begin + next});
    }
  }
}

void BoundaryMap::sort_into_cells() {
  Extents all;
  for (const Side& side : sides_) {
    all.low = {std::min(all.low.x, side.segment.from.x), std::min(all.low.y, side.segment.from.y)};
    all.high = {std::max(all.high.x, side.segment.from.x), std::max(all.high.y, side.segment.from.y)};
  }
  if (sides_.empty()) all = {{}, {}};
  low_ = all.low;
  const Vec2 extent = all.high - all.low;
  cell_px_ = std::max(kCell_px, float(std::sqrt(double(extent.x) * double(extent.y) / kMostCells)));
  columns_ = int(extent.x / cell_px_) + 1;
  rows_ = int(extent.y / cell_px_) + 1;
  const auto each_cell = [&](const Side& side, auto f) {
    const Segment& s = side.segment;
    const Cells cells = cells_of({std::min(s.from.x, s.to.x), std::min(s.from.y, s.to.y)},
                                 {std::max(s.from.x, s.to.x), std::max(s.from.y, s.to.y)});
    for (int y = cells.y0; y <= cells.y1; ++y) {
      for (int x = cells.x0; x <= cells.x1; ++x) f(std::size_t(y) * columns_ + x);
    }
  };
  first_.assign(std::size_t(columns_) * rows_ + 1, 0);
  for (const Side& side : sides_) each_cell(side, [&](std::size_t cell) { ++first_[cell + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  sorted_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < sides_.size(); ++i) {
    each_cell(sides_[i], [&](std::size_t cell) { sorted_[next[cell]++] = i; });
  }
}

BoundaryMap::Cells BoundaryMap::cells_of(Vec2 low, Vec2 high) const {
  const auto cell = [&](float v, float from, int count) {
    return int(std::clamp((v - from) / cell_px_, 0.f, float(count - 1)));
  };
  return {cell(low.x, low_.x, columns_), cell(low.y, low_.y, rows_), cell(high.x, low_.x, columns_),
          cell(high.y, low_.y, rows_)};
}

template <class F>
void BoundaryMap::each_in(const Cells& cells, F f) const {
  for (int y = cells.y0; y <= cells.y1; ++y) {
    const std::uint32_t* row = first_.data() + std::size_t(y) * columns_;
    for (std::uint32_t i = row[cells.x0]; i < row[cells.x1 + 1]; ++i) f(sorted_[i]);
  }
}

/// Whether p lies inside the piece to which `side`, the nearest one to p, belongs. At a corner both sides that meet
/// there decide together.
bool BoundaryMap::is_inside_of(const Side& side, Vec2 p) const {
  const auto left_of = [&](const Side& s) { return cross(s.segment.to - s.segment.from, p - s.segment.from) > 0; };
  const Vec2 d = side.segment.to - side.segment.from;
  const float along = dot(p - side.segment.from, d);
  const bool at_start = along <= 0, at_end = along >= dot(d, d);
  if (!at_start && !at_end) return left_of(side);
  const Side& in = at_start ? sides_[side.before] : side;
  const Side& out = at_start ? side : sides_[side.after];
  const bool convex = cross(in.segment.to - in.segment.from, out.segment.to - out.segment.from) > 0;
  return convex ? left_of(in) && left_of(out) : left_of(in) || left_of(out);
}

NearestOther BoundaryMap::nearest_other(Vec2 p, std::uint32_t piece, float reach_px) const {
  float best = reach_px;
  const Side* nearest = nullptr;
  // Sides beyond this radius lie in cells that are not searched.
  for (float radius = std::min(cell_px_, reach_px);; radius = std::min(2 * radius, reach_px)) {
    each_in(cells_of(p - Vec2{radius, radius}, p + Vec2{radius, radius}), [&](std::uint32_t i) {
      const Side& side = sides_[i];
      if (is_own(side, piece)) return;
      const float distance = norm(p - nearest_point(side.segment, p));
      if (distance >= best) return;
      best = distance;
      nearest = &side;
    });
    if (best <= radius || radius >= reach_px) break;
  }
  if (nearest == nullptr) return {best, {}};
  return {is_inside_of(*nearest, p) ? -best : best, nearest->piece};
}

RayHits BoundaryMap::hits(Vec2 from, Vec2 direction, float length_px, std::uint32_t piece) const {
  const Vec2 to = from + direction * length_px;
  RayHits hits{length_px, length_px};
  each_in(cells_of({std::min(from.x, to.x), std::min(from.y, to.y)}, {std::max(from.x, to.x), std::max(from.y, to.y)}),
          [&](std::uint32_t i) {
            const float at = crossing(from, direction, sides_[i].segment);
            const bool own = is_own(sides_[i], piece);
            if (at < (own ? kSelf_px : 0)) return;
            float& hit = own ? hits.own_px : hits.other_px;
            hit = std::min(hit, at);
          });
  return hits;
}

bool BoundaryMap::crosses_itself(std::uint32_t piece) const {
  for (std::uint32_t i = own_sides_[piece]; i < own_sides_[piece + 1]; ++i) {
    const Segment& s = sides_[i].segment;
    bool crosses = false;
    each_in(cells_of({std::min(s.from.x, s.to.x), std::min(s.from.y, s.to.y)},
                     {std::max(s.from.x, s.to.x), std::max(s.from.y, s.to.y)}),
            [&](std::uint32_t k) {
              if (k <= i || !is_own(sides_[k], piece) || k == sides_[i].after || k == sides_[i].before) return;
              crosses |= cross_each_other(s, sides_[k].segment);
            });
    if (crosses) return true;
  }
  return false;
}

}  // namespace tessera
