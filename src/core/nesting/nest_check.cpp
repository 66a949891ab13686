#include "core/nesting/nest_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/nesting/nest_poles.h"

namespace tessera {
namespace {

/// Where the side ab is cut by the ring, as parts of its length, its ends among them.
std::vector<double> cuts(NestPoint a, NestPoint b, const NestRing& ring) {
  std::vector<double> cuts{0, 1};
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    if (!segments_meet(a, b, ring[j], ring[i])) continue;
    const double d = cross(b - a, ring[i] - ring[j]);
    if (d == 0) continue;
    cuts.push_back(std::clamp(cross(ring[j] - a, ring[i] - ring[j]) / d, 0.0, 1.0));
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/// Of points of `inner`'s boundary and one inside it.
double depth_in(const NestRing& inner, const NestRing& outer) {
  double depth = 0;
  const auto look = [&](NestPoint p) {
    if (contains(outer, p)) depth = std::max(depth, distance_to_boundary(outer, p));
  };
  const NestBox window = box_of(outer);
  for (std::size_t i = 0, j = inner.size() - 1; i < inner.size(); j = i++) {
    const NestBox side = box_of({inner[j], inner[i]});
    if (side.high.x < window.low.x || side.low.x > window.high.x || side.high.y < window.low.y ||
        side.low.y > window.high.y)
      continue;
    look(inner[i]);
    const std::vector<double> at = cuts(inner[j], inner[i], outer);
    for (std::size_t k = 1; k < at.size(); ++k) look(inner[j] + (inner[i] - inner[j]) * ((at[k - 1] + at[k]) / 2));
  }
  look(poles_of(inner, 1).front().centre);
  return depth;
}

bool boxes_apart(const NestBox& a, const NestBox& b, double by) {
  return a.low.x > b.high.x + by || b.low.x > a.high.x + by || a.low.y > b.high.y + by || b.low.y > a.high.y + by;
}

double between_sides(NestPoint a, NestPoint b, NestPoint c, NestPoint d) {
  if (segments_meet(a, b, c, d)) return 0;
  return std::min(std::min(distance_to_boundary({c, d}, a), distance_to_boundary({c, d}, b)),
                  std::min(distance_to_boundary({a, b}, c), distance_to_boundary({a, b}, d)));
}

std::string count_fault(const NestProblem& problem, const NestLayout& layout) {
  std::vector<int> counts = layout.left_over;
  counts.resize(problem.items.size(), 0);
  for (const NestedPiece& piece : layout.pieces) {
    if (piece.item < 0 || piece.item >= int(counts.size())) return "a piece of no item";
    if (piece.angle < 0 || piece.angle >= int(problem.items[std::size_t(piece.item)].angles_deg.size()))
      return "a piece at no angle of its own";
    ++counts[std::size_t(piece.item)];
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] != problem.items[i].demand) return "item " + std::to_string(i) + " is there another number of times";
  }
  return "";
}

}  // namespace

double nest_depth(const NestRing& a, const NestRing& b) {
  if (boxes_apart(box_of(a), box_of(b), 0)) return 0;
  return std::max(depth_in(a, b), depth_in(b, a));
}

double nest_distance(const NestRing& a, const NestRing& b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = a.size() - 1; i < a.size(); j = i++) {
    for (std::size_t k = 0, l = b.size() - 1; k < b.size(); l = k++)
      least = std::min(least, between_sides(a[j], a[i], b[l], b[k]));
  }
  return least;
}

std::string nest_fault(const NestProblem& problem, const NestLayout& layout) {
  if (const std::string fault = count_fault(problem, layout); !fault.empty()) return fault;
  const double tolerance = kNestTolerance * problem.height;
  std::vector<NestRing> rings;
  std::vector<NestBox> boxes;
  for (const NestedPiece& piece : layout.pieces) {
    rings.push_back(placed_outline(problem, piece));
    boxes.push_back(box_of(rings.back()));
    const NestBox& box = boxes.back();
    const double length = piece.sheet + 1 == layout.sheets ? layout.used_length : problem.length;
    if (!(box.low.x >= -tolerance && box.low.y >= -tolerance && box.high.y <= problem.height + tolerance &&
          box.high.x <= length + tolerance))
      return "piece " + std::to_string(rings.size() - 1) + " sticks out";
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (layout.pieces[i].sheet != layout.pieces[j].sheet || boxes_apart(boxes[i], boxes[j], problem.spacing))
        continue;
      const std::string both = "pieces " + std::to_string(j) + " and " + std::to_string(i);
      if (nest_depth(rings[i], rings[j]) > tolerance) return both + " overlap";
      if (problem.spacing > 0 && nest_distance(rings[i], rings[j]) < problem.spacing - tolerance)
        return both + " are too near";
    }
  }
  return "";
}

}  // namespace tessera
