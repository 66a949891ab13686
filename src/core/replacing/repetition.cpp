#include "core/replacing/repetition.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>

#include "core/base/portable_math.h"

namespace tessera {
namespace {

struct ByDrawing {
  template <class A>
  bool operator()(const A& a, ShapeId id) const {
    return a.drawing < id;
  }
  template <class A>
  bool operator()(ShapeId id, const A& a) const {
    return id < a.drawing;
  }
};

template <class Areas>
auto place_of(Areas& drawn, ShapeId drawing) {
  return std::lower_bound(drawn.begin(), drawn.end(), drawing, ByDrawing{});
}

double area_px2(const PlacedDrawing& piece) { return double(piece.scale_px) * double(piece.scale_px); }

double area_px2(std::span<const PlacedDrawing> pieces) {
  double sum_px2 = 0;
  for (const PlacedDrawing& piece : pieces) sum_px2 += area_px2(piece);
  return sum_px2;
}

/// The cost of all pairs of copies; `copies` ascend by x.
double near_px2(std::span<const PlacedDrawing> copies, float reach_sizes, const Period& period) {
  float largest_px = 0;
  for (const PlacedDrawing& piece : copies) largest_px = std::max(largest_px, piece.scale_px);
  const float most_px = period.x_px > 0 ? std::numeric_limits<float>::infinity() : reach_sizes * largest_px;
  double sum_px2 = 0;
  for (std::size_t i = 0; i < copies.size(); ++i) {
    for (std::size_t k = i + 1; k < copies.size(); ++k) {
      PlacedDrawing other = copies[k];
      if (other.centre_px.x - copies[i].centre_px.x > most_px) break;
      other.centre_px = period.nearest(other.centre_px, copies[i].centre_px);
      sum_px2 += near_px2(copies[i], other, reach_sizes);
    }
  }
  return sum_px2;
}

}  // namespace

double repeated_px2(double area_px2, double even_share_px2) {
  return area_px2 > 0 ? area_px2 * (portable_log(area_px2 / even_share_px2) - 1) : 0;
}

double near_px2(const PlacedDrawing& a, const PlacedDrawing& b, float reach_sizes) {
  const float reach_px = reach_sizes * std::sqrt(a.scale_px * b.scale_px);
  const float distance_px = norm(a.centre_px - b.centre_px);
  if (!(distance_px < reach_px)) return 0;
  return area_px2(a.scale_px < b.scale_px ? a : b) * double(1 - distance_px / reach_px);
}

double repetition_px2(std::vector<PlacedDrawing> pieces, const RepetitionCosts& costs, const Period& period) {
  std::sort(pieces.begin(), pieces.end(), [](const PlacedDrawing& a, const PlacedDrawing& b) {
    return std::tie(a.drawing, a.centre_px.x, a.centre_px.y, a.scale_px) <
           std::tie(b.drawing, b.centre_px.x, b.centre_px.y, b.scale_px);
  });
  double sum_px2 = 0;
  for (auto first = pieces.begin(); first != pieces.end();) {
    const auto last = std::upper_bound(first, pieces.end(), first->drawing, ByDrawing{});
    const std::span copies(first, last);
    sum_px2 += costs.area * repeated_px2(area_px2(copies), costs.even_share_px2);
    sum_px2 += costs.nearness * near_px2(copies, costs.reach_sizes, period);
    first = last;
  }
  return sum_px2;
}

Repetition::Repetition(const ReplacementWindow& window)
    : costs_(window.repetition),
      drawn_(window.drawn),
      pieces_(window.elsewhere) {
  for (const WindowPiece& piece : window.moving)
    pieces_.push_back(placed_drawing(piece.drawing, piece.canvas_from_shape));
  std::stable_sort(pieces_.begin(), pieces_.end(),
                   [](const PlacedDrawing& a, const PlacedDrawing& b) { return a.drawing < b.drawing; });
}

double Repetition::drawn_px2(ShapeId drawing) const {
  const auto found = place_of(drawn_, drawing);
  return found == drawn_.end() || found->drawing != drawing ? 0 : found->area_px2;
}

double Repetition::of_area_px2(double drawn_px2) const {
  return costs_.area * repeated_px2(drawn_px2, costs_.even_share_px2);
}

double Repetition::of_nearness_px2(const PlacedDrawing& piece) const {
  const auto [first, last] = std::equal_range(pieces_.begin(), pieces_.end(), piece.drawing, ByDrawing{});
  double sum_px2 = 0;
  for (auto copy = first; copy != last; ++copy) sum_px2 += near_px2(piece, *copy, costs_.reach_sizes);
  return costs_.nearness * sum_px2;
}

double Repetition::cost_px2(const PlacedDrawing& piece) const {
  const double before_px2 = drawn_px2(piece.drawing);
  const double after_px2 = before_px2 + area_px2(piece);
  return of_area_px2(after_px2) - of_area_px2(before_px2) + of_nearness_px2(piece);
}

void Repetition::add(const PlacedDrawing& piece) {
  energy_px2_ += of_nearness_px2(piece);
  pieces_.insert(std::upper_bound(pieces_.begin(), pieces_.end(), piece.drawing, ByDrawing{}), piece);
  change_area(piece.drawing, area_px2(piece));
}

void Repetition::remove(const PlacedDrawing& piece) {
  const auto [first, last] = std::equal_range(pieces_.begin(), pieces_.end(), piece.drawing, ByDrawing{});
  const auto found = std::find(first, last, piece);
  if (found == last) return;
  pieces_.erase(found);
  energy_px2_ -= of_nearness_px2(piece);
  change_area(piece.drawing, -area_px2(piece));
}

void Repetition::change_area(ShapeId drawing, double by_px2) {
  auto found = place_of(drawn_, drawing);
  if (found == drawn_.end() || found->drawing != drawing) found = drawn_.insert(found, {drawing, 0});
  const double before_px2 = found->area_px2;
  found->area_px2 += by_px2;
  energy_px2_ += of_area_px2(found->area_px2) - of_area_px2(before_px2);
}

}  // namespace tessera
