#include "products/puzzle/puzzle_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/portable_math.h"
#include "core/geometry/polygon.h"
#include "products/puzzle/polygon_parts.h"

namespace tessera {
namespace {

using Curve = std::vector<Vec2>;

/// Random numbers with names (purpose and place), so that none depends on how many were drawn before.
class NamedDraws {
 public:
  explicit NamedDraws(std::uint64_t seed) : seed_(mix_bits(seed)) {}

  /// A number in [low, high).
  float between(float low, float high, std::uint64_t place, std::uint64_t what) const {
    const std::uint64_t bits = mix_bits(seed_ ^ mix_bits(place * 64 + what));
    return low + (high - low) * unit_float(std::uint32_t(bits >> 32));
  }

 private:
  std::uint64_t seed_;
};

struct GridSize {
  int columns, rows;
};

/// The grid with the number of pieces nearest to the wish, among those with nearly square pieces.
GridSize grid_size(const CutRequest& request) {
  GridSize best{1, 1};
  double least = INFINITY;
  for (int rows = 1; rows <= request.pieces; ++rows) {
    for (const int columns : {request.pieces / rows, request.pieces / rows + 1}) {
      const double number = std::abs(double(rows) * columns - request.pieces) / request.pieces;
      const double aspect = double(request.width_px) / columns * rows / request.height_px;
      const double cost = 20 * number + std::max(aspect, 1 / aspect);
      if (columns * rows < 2 || cost >= least) continue;
      least = cost;
      best = {columns, rows};
    }
  }
  return best;
}

Vec2 bezier(const std::array<Vec2, 4>& p, float t) {
  const float s = 1 - t;
  return p[0] * (s * s * s) + p[1] * (3 * s * s * t) + p[2] * (3 * s * t * t) + p[3] * (t * t * t);
}

/// A side from (0, 0) to (1, 0) with a tab towards positive y, including both ends. Neck, head and shoulders vary, so that
/// no two sides are alike.
Curve unit_side(const NamedDraws& draws, std::uint64_t side) {
  constexpr int kSteps = 24;  // of each of its three curves
  const float head = draws.between(0.085f, 0.115f, side, 0);
  const float middle = 0.5f + draws.between(-0.07f, 0.07f, side, 1);
  const float lean = draws.between(-0.04f, 0.04f, side, 2);
  const float height = draws.between(-0.03f, 0.03f, side, 3);
  const float first = draws.between(-0.06f, 0.06f, side, 4), last = draws.between(-0.06f, 0.06f, side, 5);
  const Vec2 neck_in{middle - head, head + height}, neck_out{middle + head, head + height};
  const std::array<std::array<Vec2, 4>, 3> curves = {{
      {{{0, 0}, {0.2f, first}, {middle + lean, height - head}, neck_in}},
      {{neck_in,
        {middle - 2 * head - lean, 3 * head + height},
        {middle + 2 * head - lean, 3 * head + height},
        neck_out}},
      {{neck_out, {middle + lean, height - head}, {0.8f, last}, {1, 0}}},
  }};
  Curve side_points = {{0, 0}};
  for (const auto& curve : curves) {
    for (int k = 1; k <= kSteps; ++k) side_points.push_back(bezier(curve, float(k) / kSteps));
  }
  return side_points;
}

/// Points of a grid, its sides, and the pieces between them.
class PuzzleGrid {
 public:
  explicit PuzzleGrid(const CutRequest& request) : request_(request), grid_(grid_size(request)), draws_(request.seed) {}

  std::vector<Curve> pieces() const {
    std::vector<Curve> all;
    for (int j = 0; j < grid_.rows; ++j) {
      for (int i = 0; i < grid_.columns; ++i) all.push_back(piece(i, j));
    }
    return all;
  }

 private:
  /// A corner of the grid. Points on the frame move only along it.
  Vec2 corner(int i, int j) const {
    const float waver = request_.style == CutStyle::tabs ? 0.1f : 0;  // of a cell
    const std::uint64_t place = std::uint64_t(j) * 100'003 + std::uint64_t(i);
    const bool fixed_x = i == 0 || i == grid_.columns, fixed_y = j == 0 || j == grid_.rows;
    const float x = float(i) + (fixed_x ? 0 : draws_.between(-waver, waver, place, 16));
    const float y = float(j) + (fixed_y ? 0 : draws_.between(-waver, waver, place, 17));
    return {x * float(request_.width_px) / float(grid_.columns), y * float(request_.height_px) / float(grid_.rows)};
  }

  /// The line from one corner to the next, to the right or down, without its last point.
  Curve side(int i, int j, bool down) const {
    const Vec2 from = corner(i, j), to = down ? corner(i, j + 1) : corner(i + 1, j);
    const bool on_frame = down ? i == 0 || i == grid_.columns : j == 0 || j == grid_.rows;
    if (on_frame || request_.style == CutStyle::rectangles) return {from};
    const std::uint64_t name = (std::uint64_t(j) * 100'003 + std::uint64_t(i)) * 2 + (down ? 1 : 0);
    const float towards = draws_.between(0, 1, name, 32) < 0.5f ? -1.f : 1.f;
    const Vec2 along = to - from;
    // Narrow pieces get smaller tabs on their long sides, because these would meet.
    const float breadth =
        down ? float(request_.width_px) / float(grid_.columns) : float(request_.height_px) / float(grid_.rows);
    const Vec2 across = Vec2{-along.y, along.x} * (towards * std::min(1.f, breadth / norm(along)));
    Curve points;
    for (const Vec2 p : unit_side(draws_, name)) points.push_back(from + along * p.x + across * p.y);
    points.pop_back();
    return points;
  }

  static void append_reversed(Curve& curve, Curve side, Vec2 start) {
    side.push_back(start);
    std::reverse(side.begin(), side.end());
    curve.insert(curve.end(), side.begin(), side.end() - 1);
  }

  Curve piece(int i, int j) const {
    Curve curve = side(i, j, false);
    const Curve right = side(i + 1, j, true);
    curve.insert(curve.end(), right.begin(), right.end());
    append_reversed(curve, side(i, j + 1, false), corner(i + 1, j + 1));
    append_reversed(curve, side(i, j, true), corner(i, j + 1));
    return curve;
  }

  CutRequest request_;
  GridSize grid_;
  NamedDraws draws_;
};

/// Random points; each is the one of several draws that is farthest from the points before.
Curve scattered_points(const CutRequest& request) {
  constexpr int kDraws = 30;
  const NamedDraws draws(request.seed);
  Curve points;
  while (points.size() < std::size_t(request.pieces)) {
    Vec2 best;
    float farthest = -1;
    for (int k = 0; k < kDraws; ++k) {
      const std::uint64_t place = points.size() * kDraws + std::size_t(k);
      const Vec2 p{draws.between(0, float(request.width_px), place, 0),
                   draws.between(0, float(request.height_px), place, 1)};
      float nearest = INFINITY;
      for (const Vec2 q : points) nearest = std::min(nearest, dot(p - q, p - q));
      if (nearest <= farthest) continue;
      farthest = nearest;
      best = p;
    }
    points.push_back(best);
  }
  return points;
}

/// The part of a convex polygon that is nearer to `here` than to `there`.
Curve nearer_part(const Curve& cell, Vec2 here, Vec2 there) {
  const Vec2 normal = there - here, middle = (here + there) * 0.5f;
  Curve part;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const Vec2 p = cell[k], q = cell[(k + 1) % cell.size()];
    const float beyond_p = dot(p - middle, normal), beyond_q = dot(q - middle, normal);
    if (beyond_p <= 0) part.push_back(p);
    if ((beyond_p < 0 && beyond_q > 0) || (beyond_p > 0 && beyond_q < 0))
      part.push_back(p + (q - p) * (beyond_p / (beyond_p - beyond_q)));
  }
  return part;
}

std::vector<Curve> cells(const CutRequest& request) {
  const float w = float(request.width_px), h = float(request.height_px);
  const Curve sites = scattered_points(request);
  std::vector<Curve> all;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    Curve cell = {{0, 0}, {w, 0}, {w, h}, {0, h}};
    for (std::size_t j = 0; j < sites.size(); ++j) {
      if (j != i) cell = nearer_part(cell, sites[i], sites[j]);
    }
    all.push_back(cell);
  }
  return all;
}

/// Makes common corners equal: each cell computes them by itself with other rounding, and the first one counts.
void weld(std::vector<Curve>& cells) {
  constexpr float kNear_px = 0.05f;
  std::vector<Vec2*> points;
  for (Curve& cell : cells) {
    for (Vec2& p : cell) points.push_back(&p);
  }
  std::stable_sort(points.begin(), points.end(), [](const Vec2* a, const Vec2* b) { return a->x < b->x; });
  std::vector<bool> welded(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (welded[i]) continue;
    for (std::size_t k = i + 1; k < points.size() && points[k]->x <= points[i]->x + kNear_px; ++k) {
      if (welded[k] || norm(*points[k] - *points[i]) > kNear_px) continue;
      *points[k] = *points[i];
      welded[k] = true;
    }
  }
  for (Curve& cell : cells) {
    cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
    while (cell.size() > 1 && cell.front() == cell.back()) cell.pop_back();
  }
}

/// Joins small parts to the neighbour with which they share most of their boundary.
void join_small(std::vector<Curve>& parts, double small_px2) {
  std::vector<double> areas;
  std::vector<Box> boxes;
  for (const Curve& part : parts) {
    areas.push_back(signed_area(part));
    boxes.push_back(bounding_box(part));
  }
  std::vector<bool> stays(parts.size());  // nothing is joined to it
  for (;;) {
    std::size_t least = parts.size();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!stays[i] && areas[i] < small_px2 && (least == parts.size() || areas[i] < areas[least])) least = i;
    }
    if (least == parts.size()) return;
    std::size_t best = parts.size();
    double longest = 0;
    std::optional<Curve> both;
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (j == least || !within_reach(boxes[least], boxes[j], 0)) continue;
      const double length = shared_length(parts[least], parts[j]);
      if (length <= longest) continue;
      std::optional<Curve> whole = joined(parts[least], parts[j]);
      if (!whole) continue;
      longest = length;
      best = j;
      both = std::move(whole);
    }
    if (!both) {
      stays[least] = true;
      continue;
    }
    parts[best] = std::move(*both);
    areas[best] += areas[least];
    boxes[best] = united(boxes[best], boxes[least]);
    parts.erase(parts.begin() + std::ptrdiff_t(least));
    areas.erase(areas.begin() + std::ptrdiff_t(least));
    boxes.erase(boxes.begin() + std::ptrdiff_t(least));
    stays.erase(stays.begin() + std::ptrdiff_t(least));
  }
}

std::vector<Curve> cells_of(const CutRequest& request) {
  return request.style == CutStyle::polygons ? cells(request) : PuzzleGrid(request).pieces();
}

/// Parts of the outline: cells over its bounding box, a little enlarged, so that no side lies on the box' edge.
std::vector<Curve> parts_of_outline(const CutRequest& request) {
  constexpr float kBeyond_px = 1;
  constexpr double kMostOfBox = 4;  // thinner shapes get fewer pieces
  constexpr double kSmall = 0.2;    // part of a usual piece's area: less is a sliver
  const double area = signed_area(request.outline);
  const Box box = bounding_box(request.outline);
  CutRequest over_box = request;
  over_box.width_px = int(std::ceil(box.width() + 2 * kBeyond_px));
  over_box.height_px = int(std::ceil(box.height() + 2 * kBeyond_px));
  const double box_area = double(over_box.width_px) * over_box.height_px;
  over_box.pieces = int(std::lround(request.pieces * std::min(kMostOfBox, box_area / area)));
  std::vector<Curve> cells = cells_of(over_box);
  for (Curve& cell : cells) {
    for (Vec2& p : cell) p = p + box.low - Vec2{kBeyond_px, kBeyond_px};
  }
  weld(cells);
  std::vector<Curve> parts;
  for (const Curve& cell : cells) {
    for (Curve& part : common_parts(cell, request.outline)) parts.push_back(std::move(part));
  }
  join_small(parts, kSmall * area / request.pieces);
  return parts;
}

}  // namespace

std::vector<std::vector<Vec2>> cut_puzzle(const CutRequest& request) {
  return request.outline.empty() ? cells_of(request) : parts_of_outline(request);
}

}  // namespace tessera
