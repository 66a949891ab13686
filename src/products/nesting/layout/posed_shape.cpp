#include "products/nesting/layout/posed_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/stop.h"
#include "products/nesting/layout/nest_tuning.h"
#include "products/nesting/layout/search_outline.h"

namespace tessera {
namespace {

constexpr std::size_t kMostPoles = 32;
static_assert(nest_tuning::kPoles <= int(kMostPoles));

NestRing turned(const NestRing& ring, const NestTurn& turn) {
  NestRing out;
  for (const NestPoint p : ring) out.push_back(turn.apply(p));
  return out;
}

/// The parts of a shape that are the same at each angle.
struct UnposedShape {
  NestRing own, body, boundary;
  std::vector<NestPole> poles;
  double hull_area;
};

UnposedShape unposed(const NestItem& item, double spacing, double depth) {
  UnposedShape shape;
  shape.own = tidied(item.outline);
  shape.body = enlarged_to_fewer_points(shape.own, nest_tuning::kAddedArea * std::abs(signed_area(shape.own)));
  shape.boundary = inset(spacing > 0 ? grown(shape.body, spacing / 2) : shape.body, depth);
  shape.poles = poles_of(shape.body, nest_tuning::kPoles);
  for (NestPole& pole : shape.poles) pole.radius += spacing / 2 - depth;
  shape.hull_area = signed_area(convex_hull(shape.boundary));
  return shape;
}

PosedShape posed(const UnposedShape& shape, const NestTurn& turn) {
  PosedShape out;
  out.boundary = turned(shape.boundary, turn);
  out.box = box_of(out.boundary);
  out.boundary.push_back(out.boundary.front());
  out.body = turned(shape.body, turn);
  out.own_box = box_of(turned(shape.own, turn));
  out.inner = turn.apply(shape.poles.front().centre);
  for (const NestPole& pole : shape.poles) {
    const NestPoint centre = turn.apply(pole.centre);
    out.pole_x.push_back(float(centre.x));
    out.pole_y.push_back(float(centre.y));
    out.pole_radius.push_back(float(pole.radius));
  }
  out.area = std::abs(signed_area(shape.own));
  out.diameter = float(std::max(out.box.width(), out.box.height()));
  out.weight = float(std::sqrt(std::sqrt(shape.hull_area)));
  return out;
}

struct Side {
  NestPoint from, to;
  NestBox box;
};

bool apart(const NestBox& a, const NestBox& b) {
  return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y;
}

NestBox box_of_side(NestPoint a, NestPoint b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

NestBox moved(const NestBox& box, NestPoint by) { return {box.low + by, box.high + by}; }

/// The shape's sides that reach into the window.
void sides_in(const PosedShape& shape, NestPoint shift, const NestBox& window, std::vector<Side>& sides) {
  sides.clear();
  NestPoint from = shape.boundary.front() + shift;
  for (std::size_t i = 1; i < shape.boundary.size(); ++i) {
    const NestPoint to = shape.boundary[i] + shift;
    const NestBox box = box_of_side(from, to);
    if (!apart(box, window)) sides.push_back({from, to, box});
    from = to;
  }
}

bool boundaries_meet(const PosedShape& a, const PosedShape& b, NestPoint b_shift, const NestBox& window) {
  thread_local std::vector<Side> a_sides, b_sides;
  sides_in(a, {}, window, a_sides);
  if (a_sides.empty()) return false;
  sides_in(b, b_shift, window, b_sides);
  for (const Side& here : a_sides) {
    for (const Side& there : b_sides) {
      if (!apart(here.box, there.box) && segments_meet(here.from, here.to, there.from, there.to)) return true;
    }
  }
  return false;
}

}  // namespace

PosedItems posed_items(const NestProblem& problem, const StopCheck& check_stop) {
  PosedItems items;
  for (const NestItem& item : problem.items) {
    check_stop();
    const UnposedShape shape = unposed(item, problem.spacing, nest_tuning::kInset * problem.height);
    std::vector<PosedShape>& angles = items.emplace_back();
    for (const double angle_deg : item.angles_deg) angles.push_back(posed(shape, turn_of(angle_deg)));
  }
  return items;
}

double overlap_estimate(const PosedShape& a, NestPoint a_shift, const PosedShape& b, NestPoint b_shift, bool& sure) {
  const float dx = float(b_shift.x - a_shift.x), dy = float(b_shift.y - a_shift.y);
  const float fading = float(nest_tuning::kFading) * std::max(a.diameter, b.diameter);
  const std::size_t count = b.pole_x.size();
  std::array<float, kMostPoles> x, y, term, depth;
  for (std::size_t j = 0; j < count; ++j) {
    x[j] = b.pole_x[j] + dx;
    y[j] = b.pole_y[j] + dy;
    term[j] = 0;
    depth[j] = 0;
  }
  const float* const radius = b.pole_radius.data();
  for (std::size_t i = 0; i < a.pole_x.size(); ++i) {
    const float ax = a.pole_x[i], ay = a.pole_y[i], ar = a.pole_radius[i];
    for (std::size_t j = 0; j < count; ++j) {
      const float rx = x[j] - ax, ry = y[j] - ay;
      const float d = ar + radius[j] - std::sqrt(rx * rx + ry * ry);
      const float smaller = ar < radius[j] ? ar : radius[j];
      const float faded = fading * fading / (2 * fading - (d < fading ? d : fading));
      term[j] += (d < fading ? faded : d) * smaller;
      depth[j] = depth[j] < d ? d : depth[j];
    }
  }
  float sum = 0, deepest = 0;
  for (std::size_t j = 0; j < count; ++j) {
    sum += term[j];
    deepest = std::max(deepest, depth[j]);
  }
  sure = deepest > 1e-5f * std::max(a.diameter, b.diameter);
  return double(std::sqrt(3.14159265f * sum + fading * fading) * a.weight * b.weight);
}

bool shapes_meet(const PosedShape& a, NestPoint a_shift, const PosedShape& b, NestPoint b_shift) {
  const NestPoint by = b_shift - a_shift;
  const NestBox there = moved(b.box, by);
  if (apart(a.box, there)) return false;
  const NestBox window{{std::max(a.box.low.x, there.low.x), std::max(a.box.low.y, there.low.y)},
                       {std::min(a.box.high.x, there.high.x), std::min(a.box.high.y, there.high.y)}};
  return boundaries_meet(a, b, by, window) || contains(a.body, b.inner + by) || contains(b.body, a.inner - by);
}

}  // namespace tessera
