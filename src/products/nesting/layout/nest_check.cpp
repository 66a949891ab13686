#include "products/nesting/layout/nest_check.h"

#include <algorithm>
#include <optional>

#include "core/base/stop.h"
#include "products/nesting/layout/nest_poles.h"
#include "products/nesting/layout/ring_rows.h"

namespace tessera {
namespace {

/// Whether the point lies inside the outline, and farther from its boundary than `depth`.
bool lies_deeper(NestPoint p, const RingRows& outer, double depth) {
  if (!outer.contains(p)) return false;
  bool is_near = false;
  outer.visit_sides({{p.x - depth, p.y - depth}, {p.x + depth, p.y + depth}}, [&](std::size_t side) {
    is_near = is_near || distance_to_boundary({outer.from(side), outer.to(side)}, p) <= depth;
  });
  return !is_near;
}

/// The cuts of the side ab by the ring, as parts of the side's length, with its ends.
void find_cuts(NestPoint a, NestPoint b, const RingRows& ring, std::vector<double>& cuts) {
  cuts.assign({0, 1});
  ring.visit_sides(box_of({a, b}), [&](std::size_t side) {
    const NestPoint c = ring.from(side), d = ring.to(side);
    const double across = cross(b - a, d - c);
    if (across == 0 || !segments_meet(a, b, c, d)) return;
    cuts.push_back(std::clamp(cross(c - a, d - c) / across, 0.0, 1.0));
  });
  std::sort(cuts.begin(), cuts.end());
}

/// Whether `inner` reaches deeper than `depth` into `outer`: tests a point of its boundary between each two cuts, and one
/// point inside it.
bool reaches_deeper(const RingRows& inner, NestPoint middle, const RingRows& outer, double depth) {
  if (lies_deeper(middle, outer, depth)) return true;
  std::vector<double> cuts;
  bool deeper = false;
  inner.visit_sides(outer.box(), [&](std::size_t side) {
    if (deeper) return;
    const NestPoint a = inner.from(side), b = inner.to(side);
    deeper = lies_deeper(b, outer, depth);
    find_cuts(a, b, outer, cuts);
    for (std::size_t k = 1; k < cuts.size() && !deeper; ++k)
      deeper = lies_deeper(a + (b - a) * ((cuts[k - 1] + cuts[k]) / 2), outer, depth);
  });
  return deeper;
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
    if (piece.item < 0 || piece.item >= int(counts.size())) return "a piece of an unknown item";
    if (piece.angle < 0 || piece.angle >= int(problem.items[std::size_t(piece.item)].angles_deg.size()))
      return "a piece at an angle that it may not have";
    ++counts[std::size_t(piece.item)];
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] != problem.items[i].demand) return "item " + std::to_string(i) + " has a wrong number of pieces";
  }
  return "";
}

NestPoint middle_of(const NestRing& ring) { return poles_of(ring, 1).front().centre; }

bool lie_deeper(const RingRows& a, NestPoint middle_of_a, const RingRows& b, NestPoint middle_of_b, double depth) {
  return reaches_deeper(a, middle_of_a, b, depth) || reaches_deeper(b, middle_of_b, a, depth);
}

bool are_nearer(const RingRows& a, const RingRows& b, double distance) {
  const NestPoint reach{distance, distance};
  bool nearer = false;
  a.visit_sides({b.box().low - reach, b.box().high + reach}, [&](std::size_t here) {
    if (nearer) return;
    const NestBox box = box_of({a.from(here), a.to(here)});
    b.visit_sides({box.low - reach, box.high + reach}, [&](std::size_t there) {
      nearer = nearer || between_sides(a.from(here), a.to(here), b.from(there), b.to(there)) < distance;
    });
  });
  return nearer;
}

/// The pieces of a layout in their poses.
class PlacedPieces {
 public:
  PlacedPieces(const NestProblem& problem, const NestLayout& layout)
      : problem_(problem),
        layout_(layout),
        middles_(problem.items.size()) {
    for (const NestedPiece& piece : layout.pieces) {
      rings_.push_back(placed_outline(problem, piece));
      boxes_.push_back(box_of(rings_.back()));
    }
  }

  std::string sticking_out(double tolerance) const {
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      const NestBox& box = boxes_[i];
      const double length = layout_.pieces[i].sheet + 1 == layout_.sheets ? layout_.used_length : problem_.length;
      if (!(box.low.x >= -tolerance && box.low.y >= -tolerance && box.high.y <= problem_.height + tolerance &&
            box.high.x <= length + tolerance))
        return "piece " + std::to_string(i) + " sticks out";
    }
    return "";
  }

  std::string too_near(double tolerance, const StopCheck& check_stop) {
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      const std::vector<std::size_t> others = near_before(i);
      if (others.empty()) continue;
      const RingRows here(rings_[i]);
      for (const std::size_t j : others) {
        check_stop();
        const RingRows there(rings_[j]);
        const std::string both = "pieces " + std::to_string(j) + " and " + std::to_string(i);
        if (lie_deeper(here, middle(i), there, middle(j), tolerance)) return both + " overlap";
        if (problem_.spacing > 0 && are_nearer(here, there, problem_.spacing - tolerance))
          return both + " are too near";
      }
    }
    return "";
  }

 private:
  std::vector<std::size_t> near_before(std::size_t i) const {
    std::vector<std::size_t> others;
    for (std::size_t j = 0; j < i; ++j) {
      if (layout_.pieces[i].sheet == layout_.pieces[j].sheet && !boxes_apart(boxes_[i], boxes_[j], problem_.spacing))
        others.push_back(j);
    }
    return others;
  }

  /// A point inside the piece; it is computed once for each item.
  NestPoint middle(std::size_t i) {
    const NestedPiece& piece = layout_.pieces[i];
    const NestItem& item = problem_.items[std::size_t(piece.item)];
    std::optional<NestPoint>& of_item = middles_[std::size_t(piece.item)];
    if (!of_item) of_item = middle_of(item.outline);
    return placed(turn_of(item.angles_deg[std::size_t(piece.angle)]), piece, *of_item);
  }

  const NestProblem& problem_;
  const NestLayout& layout_;
  std::vector<std::optional<NestPoint>> middles_;  // of each item
  std::vector<NestRing> rings_;
  std::vector<NestBox> boxes_;
};

}  // namespace

bool lie_deeper(const NestRing& a, const NestRing& b, double depth) {
  return lie_deeper(RingRows(a), middle_of(a), RingRows(b), middle_of(b), depth);
}

bool are_nearer(const NestRing& a, const NestRing& b, double distance) {
  return are_nearer(RingRows(a), RingRows(b), distance);
}

std::string nest_fault(const NestProblem& problem, const NestLayout& layout, const StopCheck& check_stop) {
  if (const std::string fault = count_fault(problem, layout); !fault.empty()) return fault;
  const double tolerance = kNestTolerance * problem.height;
  PlacedPieces pieces(problem, layout);
  const std::string fault = pieces.sticking_out(tolerance);
  return fault.empty() ? pieces.too_near(tolerance, check_stop) : fault;
}

}  // namespace tessera
