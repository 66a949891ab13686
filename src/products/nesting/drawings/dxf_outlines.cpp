#include "products/nesting/drawings/dxf_outlines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "products/nesting/drawings/nest_contours.h"

namespace tessera {
namespace {

constexpr double kWhole_rad = 2 * std::numbers::pi;

bool is_seen_from_below(const DxfEntity& entity) { return entity.numbers.get(230, 1) < 0; }

NestPoint point(const DxfEntity& entity, int code) { return {entity.numbers.get(code), entity.numbers.get(code + 10)}; }

/// An arc of a circle or ellipse: centre + u cos t + v sin t, t from `first` to `last`, rad.
NestRing arc(NestPoint centre, NestPoint u, NestPoint v, double first, double last, const Affine& map) {
  if (last <= first) last += kWhole_rad * std::ceil((first - last) / kWhole_rad + 1e-12);
  const bool is_whole = last - first >= kWhole_rad * (1 - 1e-9);
  if (is_whole) last = first + kWhole_rad;
  const NestPoint at = map.apply(centre), x = map.turned(u), y = map.turned(v);
  NestRing ring = {at + x * std::cos(first) + y * std::sin(first)};
  if (u != NestPoint{}) add_arc(at, x, y, first, last, ring);
  if (is_whole) ring.back() = ring.front();
  return ring;
}

/// Adds the arc from `from` to `to`. `from`, under the map, is ring.back().
void add_bulge(double bulge, NestPoint from, NestPoint to, const Affine& map, NestRing& ring) {
  const NestPoint chord = to - from;
  if (std::abs(bulge) >= 1e-9 && from != to) {
    // of the centre above the chord, in lengths of the chord
    const double height = (1 - bulge * bulge) / (4 * bulge);
    const NestPoint centre = (from + to) * 0.5 + NestPoint{-chord.y, chord.x} * height;
    const NestPoint u = from - centre, v{-u.y, u.x};
    add_arc(map.apply(centre), map.turned(u), map.turned(v), 0, 4 * std::atan(bulge), ring);
    ring.pop_back();
  }
  ring.push_back(map.apply(to));
}

NestRing polyline(const DxfEntity& entity, const Affine& map, std::size_t most) {
  constexpr unsigned kIsClosed = 1;
  NestRing ring;
  const std::vector<DxfVertex>& vertices = entity.vertices;
  for (std::size_t i = 0; i < vertices.size() && ring.size() <= most; ++i) {
    if (i == 0)
      ring.push_back(map.apply(vertices[i].at));
    else
      add_bulge(vertices[i - 1].bulge, vertices[i - 1].at, vertices[i].at, map, ring);
  }
  if (entity.numbers.has_bit(70, kIsClosed) && !ring.empty())
    add_bulge(vertices.back().bulge, vertices.back().at, vertices.front().at, map, ring);
  return ring;
}

NestRing ellipse(const DxfEntity& entity, const Affine& map) {
  const NestPoint u = point(entity, 11);
  const double ratio = entity.numbers.get(40, 1) * (is_seen_from_below(entity) ? -1 : 1);
  return arc(point(entity, 10), u, NestPoint{-u.y, u.x} * ratio, entity.numbers.get(41),
             entity.numbers.get(42, kWhole_rad), map);
}

}  // namespace

Affine plane_of(const DxfEntity& entity) {
  // The points of an ELLIPSE are those of the drawing, but it turns in the opposite direction.
  const bool is_mirrored = is_seen_from_below(entity) && !is_in_world(entity) && entity.kind != "ELLIPSE";
  return is_mirrored ? Affine{-1, 0, 0, 1, 0, 0} : Affine{};
}

Nurbs nurbs_of(const DxfEntity& spline, const Affine& map) {
  Nurbs curve{int(std::clamp(spline.numbers.get(71, 3), 0.0, 100.0)), {}, spline.knots, spline.weights};
  for (const DxfVertex& vertex : spline.vertices) curve.points.push_back(map.apply(vertex.at));
  return curve;
}

NestRing dxf_outline(const DxfEntity& entity, const Affine& map, std::size_t most) {
  const Affine placed = map.after(plane_of(entity));
  if (is_polyline(entity.kind)) return polyline(entity, placed, most);
  if (entity.kind == "SPLINE") return nurbs_outline(nurbs_of(entity, placed), kFlatness_mm, most);
  if (entity.kind == "ELLIPSE") return ellipse(entity, placed);
  if (entity.kind == "LINE") return {placed.apply(point(entity, 10)), placed.apply(point(entity, 11))};
  const double radius = entity.numbers.get(40);
  const bool is_circle = entity.kind == "CIRCLE";
  const double first = is_circle ? 0 : entity.numbers.get(50) * std::numbers::pi / 180;
  const double last = is_circle ? kWhole_rad : entity.numbers.get(51) * std::numbers::pi / 180;
  return arc(point(entity, 10), {std::max(radius, 0.0), 0}, {0, std::max(radius, 0.0)}, first, last, placed);
}

}  // namespace tessera
