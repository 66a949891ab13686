#include "core/collage/placed_outlines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "core/field/line_art.h"
#include "core/field/piece_distance.h"
#include "core/geometry/rasterise.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_field.h"

namespace tessera {
namespace {

/// Positions are written with three decimals, so two outlines may come this much nearer to each other in the file.
constexpr float kWritten_px = 0.002f;
/// Spacing of the points at which the canvas' edge, which is a field, is looked up.
constexpr float kEdgeSpacing_px = 1;
/// A vertex with a field value below this is tested exactly: at thin tips fields are wrong by up to this and the
/// allowed depth together.
constexpr float kSuspect_px = 0.5f;
/// The value of a shape's own field below which a vertex is tested exactly. The limit is larger than
/// kSuspect_px, because the free field, which is interpolated twice, may show a little more.
constexpr float kSuspectPlaced_px = 0.75f;

/// Pieces that still move end at the very limit. With this margin rounding does not hide a conflict from one of the
/// two.
constexpr float kFromBothSides_px = 0.001f;

/// Adds the rounding margin. A permitted overlap (negative) never becomes a distance.
float with_rounding_margin(float needed_px) {
  return needed_px > 0 ? needed_px + kFromBothSides_px : std::min(needed_px + kFromBothSides_px, 0.f);
}

/// The box of a piece that was taken out: near to nothing.
constexpr Box kNowhere{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

bool is_anywhere(const Box& box) { return box.low.x <= box.high.x; }

TileIndex::Tile tile_of(const Box& box) {
  return TileIndex::tile_at(int(std::floor(box.low.x)), int(std::floor(box.low.y)));
}

bool within(const Box& box, Vec2 p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

Vec2 middle(const Box& box) { return (box.low + box.high) * 0.5f; }

/// The direction with length `by`.
Vec2 along(Vec2 direction, float by) { return direction * (by / std::max(norm(direction), 1e-6f)); }

template <class F>
void each_segment(const Outline& outline, F f) {
  for (const std::vector<Vec2>& curve : outline.curves) {
    for (std::size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) f(Segment{curve[j], curve[i]});
  }
}

/// Sets `way` to the way out for the deepest vertex of `inner` that lies deeper than `limit` in `outer`; false if there
/// is none. Only vertices for which `suspect` is true are tested.
template <class Suspect>
bool deepest_vertex(const PolygonIndex& inner, const PolygonIndex& outer, float limit, Suspect suspect, Vec2& way) {
  float deepest = limit;
  for (const std::vector<Vec2>& curve : inner.outline().curves) {
    for (const Vec2 p : curve) {
      // Nearly all suspect vertices are near the boundary.
      if (!within(outer.box(), p) || !suspect(p) || outer.nearer_than(deepest, p) || !outer.contains(p)) continue;
      const Approach out = outer.approach(p, kMaxPushDepth_px);
      if (out.distance <= deepest) continue;
      deepest = out.distance;
      // If the boundary is out of reach, there is no short way.
      const Vec2 direction =
          out.distance < kMaxPushDepth_px ? out.there - p : middle(inner.box()) - middle(outer.box());
      way = along(direction, deepest - limit);
    }
  }
  return deepest > limit;
}

/// The way for a piece that crosses the other, until they are `apart_px` apart: out of the deepest vertex if there is
/// one, otherwise along the line between the boxes' middles.
Vec2 way_out(const PolygonIndex& piece, const PolygonIndex& other, float apart_px) {
  const auto suspect = [](Vec2) { return true; };
  Vec2 own, others;
  const bool in_other = deepest_vertex(piece, other, 0, suspect, own);
  const bool in_piece = deepest_vertex(other, piece, 0, suspect, others);
  if (!in_other && !in_piece) return along(middle(piece.box()) - middle(other.box()), apart_px);
  const Vec2 out = !in_piece || (in_other && norm(own) >= norm(others)) ? own : others * -1.f;
  return along(out, norm(out) + apart_px);
}

Outline moved(Outline outline, Vec2 by) {
  for (std::vector<Vec2>& curve : outline.curves) {
    for (Vec2& p : curve) p = p + by;
  }
  return outline;
}

auto key_of(const Placement& p) {
  const Similarity& s = p.canvas_from_shape;
  return std::tuple(p.shape, s.a, s.b, s.tx, s.ty);
}

/// Required distance of two boundaries; negative: permitted depth of one in the other.
float needed_px(const PieceSettings& pieces) {
  const bool apart = pieces.padding_px > 0 || pieces.overlap_px == 0;
  return apart ? pieces.padding_px + kWritten_px : -pieces.overlap_px;
}

}  // namespace

Outline placed_outline(const Outline& outline, const Similarity& canvas_from_shape) {
  Outline placed = outline;
  for (std::vector<Vec2>& curve : placed.curves) {
    for (Vec2& p : curve) p = canvas_from_shape.apply(p);
  }
  return placed;
}

PlacedOutlines::PlacedOutlines(const FreeField& free, const PieceSettings& pieces)
    : free_(free),
      needed_px_(needed_px(pieces)) {}

void PlacedOutlines::add(const Placement& placement, const Outline& outline, float line_radius) {
  const auto placed = std::make_shared<PolygonIndex>(placed_outline(outline, placement.canvas_from_shape));
  placed_.push_back({placement, placed, kNowhere, line_radius});
  set_box(placed_.size() - 1, placed->box());
}

void PlacedOutlines::set_box(std::size_t index, const Box& box) {
  Box& known = placed_[index].box;
  if (is_anywhere(known)) index_.erase(tile_of(known), std::uint32_t(index));
  known = box;
  if (!is_anywhere(box)) return;
  index_.insert(tile_of(box), std::uint32_t(index));
  largest_px_ = {std::max(largest_px_.x, box.width()), std::max(largest_px_.y, box.height())};
}

std::vector<std::size_t> PlacedOutlines::near(const Box& piece, float reach_px) const {
  const auto below = [](float at) { return int(std::floor(at)); };
  const Window corners{below(piece.low.x - largest_px_.x - reach_px), below(piece.low.y - largest_px_.y - reach_px),
                       below(piece.high.x + reach_px) + 1, below(piece.high.y + reach_px) + 1};
  std::vector<std::size_t> found;
  index_.each(corners, [&](std::uint32_t i) {
    if (within_reach(piece, placed_[i].box, reach_px)) found.push_back(i);
  });
  std::sort(found.begin(), found.end());
  return found;
}

float PlacedOutlines::required_distance_px(float needed_px, float line_radius_px) {
  return needed_px > 0 ? needed_px : -most_depth_px(-needed_px, line_radius_px);
}

void PlacedOutlines::move(std::size_t index, const Similarity& canvas_from_shape, const Outline& outline) {
  Placed& placed = placed_[index];
  placed.placement.canvas_from_shape = canvas_from_shape;
  placed.outline = std::make_shared<PolygonIndex>(placed_outline(outline, canvas_from_shape));
  set_box(index, placed.outline->box());
}

void PlacedOutlines::take_out(std::size_t index) {
  placed_[index].outline.reset();
  set_box(index, kNowhere);
}

void PlacedOutlines::replace(const std::vector<Placement>& placements, ShapeSource& shapes) {
  std::map<decltype(key_of({})), Placed> known;
  for (const Placed& placed : placed_) {
    if (placed.outline) known.emplace(key_of(placed.placement), placed);
  }
  placed_.clear();
  index_ = {};
  for (const Placement& p : placements) {
    const auto found = known.find(key_of(p));
    if (found == known.end()) {
      const Shape& shape = shapes.shape(p.shape);
      add(p, shape.outline, line_radius(shape.field, shape.perimeter));
    } else {
      placed_.push_back(found->second);
      placed_.back().placement = p;
      placed_.back().box = kNowhere;
      set_box(placed_.size() - 1, found->second.box);
    }
  }
}

bool PlacedOutlines::too_near(const PolygonIndex& piece, const PolygonIndex& other, float needed_px, Vec2& way) {
  const Approach nearest = approach_of(piece, other, needed_px);
  if (nearest.distance < needed_px && nearest.distance > 0) {
    way = along(nearest.here - nearest.there, needed_px - nearest.distance);
    return true;
  }
  // Even if the boundaries are far apart, one polygon may lie inside the other.
  const bool crossed = nearest.distance <= 0 || other.contains(piece.outline().curves.front().front()) ||
                       piece.contains(other.outline().curves.front().front());
  if (crossed) way = way_out(piece, other, needed_px);
  return crossed;
}

bool PlacedOutlines::too_near_the_edge(const PolygonIndex& piece, float needed_px, Vec2& way) const {
  float worst = needed_px;
  const Box& box = piece.box();
  const float half_diagonal_px = norm(box.high - middle(box));
  if (free_.canvas_sample(middle(box)).value - PieceDistance::most_change_px(half_diagonal_px) > worst) return false;
  each_segment(piece.outline(), [&](const Segment& s) {
    const Vec2 edge = s.to - s.from;
    const int steps = 1 + int(norm(edge) / kEdgeSpacing_px);
    for (int i = 0; i < steps; ++i) {
      const Vec2 p = s.from + edge * (float(i) / float(steps));
      const FieldSample at = free_.canvas_sample(p);
      if (at.value >= worst) continue;
      worst = at.value;
      way = along(at.gradient, needed_px - worst);
    }
  });
  if (worst < needed_px) return true;
  way = {};
  return free_.has_zones() && holds_a_zone(piece, needed_px);
}

/// Whether the piece surrounds a zone that its boundary did not meet.
bool PlacedOutlines::holds_a_zone(const PolygonIndex& piece, float needed_px) const {
  const Window around = bounding_window(piece.outline(), {});
  for (const Span& span : fill_spans(piece.outline(), {}, around)) {
    for (int x = span.x0; x < span.x1; ++x) {
      if (free_.canvas_sample({float(x) + 0.5f, float(span.y) + 0.5f}).value < needed_px) return true;
    }
  }
  return false;
}

/// Tests the box: a piece longer than the period may not stand, even if it could pass its own image.
bool PlacedOutlines::reaches_itself(const Box& piece) const {
  const Period& period = free_.grid().period();
  return (period.x_px > 0 && piece.width() + needed_px_ > float(period.x_px)) ||
         (period.y_px > 0 && piece.height() + needed_px_ > float(period.y_px));
}

/// `needed_px`: without regard to the other pieces' lines.
void PlacedOutlines::add_neighbours(const Shape& shape, const Similarity& canvas_from_shape, const PolygonIndex& piece,
                                    float needed_px, std::vector<Vec2>& ways) const {
  const PieceDistance distance(shape, canvas_from_shape, 0);
  const FieldView free = free_.view();
  for (const std::size_t i : near(piece.box(), std::max(needed_px, 0.f))) {
    const Placed& placed = placed_[i];
    const PolygonIndex& other = *placed.outline;
    const auto in_others = [&](Vec2 p) { return field_value(free, p) < kSuspect_px; };
    const auto in_piece = [&](Vec2 p) { return distance.at(p) < kSuspect_px; };
    add_ways(piece, in_piece, other, in_others, required_distance_px(needed_px, placed.line_radius_px()), ways);
  }
}

template <class InPiece, class InOther>
void PlacedOutlines::add_ways(const PolygonIndex& piece, InPiece in_piece, const PolygonIndex& other, InOther in_other,
                              float needed_px, std::vector<Vec2>& ways) const {
  Vec2 way;
  if (needed_px > 0) {
    if (too_near(piece, other, needed_px, way)) ways.push_back(way);
    return;
  }
  const float limit = -needed_px;
  if (deepest_vertex(piece, other, limit, in_other, way)) ways.push_back(way);
  if (deepest_vertex(other, piece, limit, in_piece, way)) ways.push_back(way * -1.f);
}

std::vector<Vec2> PlacedOutlines::conflicts(const Shape& shape, const Similarity& canvas_from_shape) const {
  const PolygonIndex piece(placed_outline(shape.outline, canvas_from_shape));
  const float needed_px =
      required_distance_px(needed_px_, line_radius(shape.field, shape.perimeter) * canvas_from_shape.scale());
  const float reach_px = std::max(needed_px, 0.f);
  std::vector<Vec2> ways;
  add_neighbours(shape, canvas_from_shape, piece, needed_px, ways);
  for (const Vec2 offset : free_.grid().period().offsets()) {
    if (offset == Vec2{} || near({piece.box().low + offset, piece.box().high + offset}, reach_px).empty()) continue;
    const Similarity image = moved(canvas_from_shape, offset);
    add_neighbours(shape, image, PolygonIndex(placed_outline(shape.outline, image)), needed_px, ways);
  }
  if (reaches_itself(piece.box())) ways.push_back({});
  Vec2 way;
  if (too_near_the_edge(piece, needed_px, way)) ways.push_back(way);
  return ways;
}

std::vector<Vec2> PlacedOutlines::conflicts_of(std::size_t index, const FieldDistance& distance_px) const {
  std::vector<Vec2> ways = conflicts_with_others(index, distance_px);
  const PolygonIndex& piece = *placed_[index].outline;
  if (reaches_itself(piece.box())) ways.push_back({});
  Vec2 way;
  if (too_near_the_edge(piece, required_distance_px(needed_px_, placed_[index].line_radius_px()), way))
    ways.push_back(way);
  return ways;
}

std::vector<Vec2> PlacedOutlines::conflicts_with_others(std::size_t index, const FieldDistance& distance_px) const {
  const PolygonIndex& piece = *placed_[index].outline;
  const float own_needed_px = required_distance_px(needed_px_, placed_[index].line_radius_px());
  const float reach_px = std::max(with_rounding_margin(own_needed_px), 0.f);
  std::vector<Vec2> ways;
  for (const Vec2 offset : free_.grid().period().offsets()) {
    const bool own_place = offset == Vec2{};
    const Box box{piece.box().low + offset, piece.box().high + offset};
    const std::vector<std::size_t> others = near(box, reach_px);
    if (!own_place && others.empty()) continue;
    std::optional<PolygonIndex> image;
    if (!own_place) image.emplace(moved(piece.outline(), offset));
    for (const std::size_t i : others) {
      if (own_place && i == index) continue;
      const auto in_piece = [&](Vec2 p) { return distance_px(index, p - offset) < kSuspectPlaced_px; };
      const auto in_other = [&](Vec2 p) { return distance_px(i, p) < kSuspectPlaced_px; };
      const float needed_px = with_rounding_margin(required_distance_px(own_needed_px, placed_[i].line_radius_px()));
      add_ways(own_place ? piece : *image, in_piece, *placed_[i].outline, in_other, needed_px, ways);
    }
  }
  return ways;
}

}  // namespace tessera
