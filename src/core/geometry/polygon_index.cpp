#include "core/geometry/polygon_index.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

constexpr int kCellsAcross = 32;  // cells along the longer side: the boundary has about as many cells as segments

bool separates(const Segment& line, Vec2 p, Vec2 q) {
  const Vec2 d = line.to - line.from;
  const double a = double(d.x) * (p.y - line.from.y) - double(d.y) * (p.x - line.from.x);
  const double b = double(d.x) * (q.y - line.from.y) - double(d.y) * (q.x - line.from.x);
  return (a > 0) != (b > 0);
}

void take_nearer(Approach& best, Vec2 here, Vec2 there) {
  const float distance = norm(here - there);
  if (distance < best.distance) best = {distance, here, there};
}

Box box_of(const Segment& s) {
  return {{std::min(s.from.x, s.to.x), std::min(s.from.y, s.to.y)},
          {std::max(s.from.x, s.to.x), std::max(s.from.y, s.to.y)}};
}

/// Whether the contents of the two boxes are certainly farther apart than `reach`, rounding included.
inline bool out_of_reach(const Box& a, const Box& b, float reach) {
  const float x = std::max({a.low.x - b.high.x, b.low.x - a.high.x, 0.f});
  const float y = std::max({a.low.y - b.high.y, b.low.y - a.high.y, 0.f});
  return x * x + y * y > reach * reach * 1.0001f;
}

}  // namespace

Vec2 nearest_point(const Segment& segment, Vec2 p) {
  const Vec2 d = segment.to - segment.from;
  const float t = std::clamp(dot(p - segment.from, d) / std::max(dot(d, d), 1e-20f), 0.f, 1.f);
  return segment.from + d * t;
}

Approach approach_of(const Segment& here, const Segment& there) {
  if (separates(here, there.from, there.to) && separates(there, here.from, here.to)) {
    const Vec2 there_middle = (there.from + there.to) * 0.5f;
    return {0, nearest_point(here, there_middle), there_middle};
  }
  Approach best{INFINITY, {}, {}};
  take_nearer(best, here.from, nearest_point(there, here.from));
  take_nearer(best, here.to, nearest_point(there, here.to));
  take_nearer(best, nearest_point(here, there.from), there.from);
  take_nearer(best, nearest_point(here, there.to), there.to);
  return best;
}

PolygonIndex::PolygonIndex(Outline outline) : outline_(std::move(outline)), box_(bounding_box(outline_)) {
  cells_per_unit_ = float(kCellsAcross) / std::max({box_.width(), box_.height(), 1e-6f});
  columns_ = int(box_.width() * cells_per_unit_) + 1;
  rows_ = int(box_.height() * cells_per_unit_) + 1;
  first_.assign(std::size_t(columns_) * rows_ + 1, 0);
  const auto each_cell = [&](const Segment& s, auto f) {
    const Cells cells = cells_round(s, 0);
    for (int y = cells.y0; y <= cells.y1; ++y) {
      for (int x = cells.x0; x <= cells.x1; ++x) f(std::size_t(y) * columns_ + x);
    }
  };
  each_segment([&](const Segment& s) { each_cell(s, [&](std::size_t cell) { ++first_[cell + 1]; }); });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  segments_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  each_segment([&](const Segment& s) { each_cell(s, [&](std::size_t cell) { segments_[next[cell]++] = s; }); });
}

template <class F>
void PolygonIndex::each_segment(F f) const {
  for (const std::vector<Vec2>& curve : outline_.curves) {
    for (std::size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) f(Segment{curve[j], curve[i]});
  }
}

int PolygonIndex::column(float x) const {
  return int(std::clamp((x - box_.low.x) * cells_per_unit_, 0.f, float(columns_ - 1)));
}

int PolygonIndex::row(float y) const {
  return int(std::clamp((y - box_.low.y) * cells_per_unit_, 0.f, float(rows_ - 1)));
}

PolygonIndex::Cells PolygonIndex::cells_round(const Segment& s, float reach) const {
  return {column(std::min(s.from.x, s.to.x) - reach), row(std::min(s.from.y, s.to.y) - reach),
          column(std::max(s.from.x, s.to.x) + reach), row(std::max(s.from.y, s.to.y) + reach)};
}

bool PolygonIndex::contains(Vec2 p) const {
  if (!(p.x >= box_.low.x && p.x <= box_.high.x && p.y >= box_.low.y && p.y <= box_.high.y)) return false;
  bool inside = false;
  const int y = row(p.y);
  for (int x = column(p.x); x < columns_; ++x) {
    const std::size_t cell = std::size_t(y) * columns_ + x;
    for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
      const Segment& s = segments_[i];
      if ((s.from.y > p.y) == (s.to.y > p.y)) continue;
      const float at = s.from.x + (s.to.x - s.from.x) * ((p.y - s.from.y) / (s.to.y - s.from.y));
      // A segment counts in the one cell where the line through p meets it.
      if (at > p.x &&
          std::clamp(column(at), column(std::min(s.from.x, s.to.x)), column(std::max(s.from.x, s.to.x))) == x) {
        inside = !inside;
      }
    }
  }
  return inside;
}

template <class F>
void PolygonIndex::each_near(const Segment& s, float reach, F f) const {
  const Cells cells = cells_round(s, reach);
  for (int y = cells.y0; y <= cells.y1; ++y) {
    // The cells of a row follow each other in segments_.
    const std::uint32_t* row = first_.data() + std::size_t(y) * columns_;
    for (std::uint32_t i = row[cells.x0]; i < row[cells.x1 + 1]; ++i) {
      if (!f(segments_[i])) return;
    }
  }
}

Approach PolygonIndex::approach(const Segment& here, float reach) const {
  Approach best{reach, {}, {}};
  const Box here_box = box_of(here);
  if (out_of_reach(here_box, box_, reach)) return best;
  const bool is_point = here.from == here.to;
  each_near(here, reach, [&](const Segment& s) {
    if (out_of_reach(here_box, box_of(s), best.distance)) return true;
    if (is_point) {
      take_nearer(best, here.from, nearest_point(s, here.from));
      return true;
    }
    const Approach approach = approach_of(here, s);
    if (approach.distance < best.distance) best = approach;
    return true;
  });
  return best;
}

bool PolygonIndex::nearer_than(float reach, Vec2 p) const {
  const Box here{p, p};
  if (out_of_reach(here, box_, reach)) return false;
  bool found = false;
  each_near({p, p}, reach, [&](const Segment& s) {
    if (!out_of_reach(here, box_of(s), reach)) found = norm(p - nearest_point(s, p)) < reach;
    return !found;
  });
  return found;
}

Approach approach_of(const PolygonIndex& here, const PolygonIndex& there, float reach) {
  Approach best{reach, {}, {}};
  for (const std::vector<Vec2>& curve : here.outline().curves) {
    for (std::size_t i = 0, j = curve.size() - 1; i < curve.size() && best.distance > 0; j = i++) {
      const Approach a = there.approach(Segment{curve[j], curve[i]}, best.distance);
      if (a.distance < best.distance) best = a;
    }
  }
  return best;
}

}  // namespace tessera
