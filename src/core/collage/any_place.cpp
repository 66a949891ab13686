#include "core/collage/any_place.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/field/field_lookup.h"

namespace tessera {
namespace {

constexpr int kPositions = 48;          // along the longer side
constexpr std::size_t kPoints = 64;     // of an outline
constexpr float kReachOfAStep = 0.75f;  // of a step: distance to the nearest position, and a little more

/// Points of the outline, farthest from the origin first: those leave the canvas first.
std::vector<Vec2> some_points(const Outline& outline) {
  const std::vector<Vec2>& curve = outline.curves.front();
  const std::size_t stride = std::max<std::size_t>(1, curve.size() / kPoints);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < curve.size(); i += stride) points.push_back(curve[i]);
  points.push_back(*std::max_element(curve.begin(), curve.end(), [](Vec2 a, Vec2 b) { return norm(a) < norm(b); }));
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return norm(a) > norm(b); });
  return points;
}

class PlaceSearch {
 public:
  PlaceSearch(const EmptyRoom& room, std::vector<Vec2> points, float scale_px)
      : room_(room),
        view_(room.distance),
        points_(std::move(points)),
        scale_px_(scale_px),
        step_px_(float(std::max(view_.width, view_.height)) / kPositions) {}

  bool finds_any(const DirectionRange& rotations) const {
    const float half_rad = std::atan2(rotations.edge.y, rotations.edge.x);
    const float turn_rad = step_px_ / std::max(step_px_, scale_px_ * norm(points_.front()));
    const int turns = int(std::ceil(half_rad / turn_rad));
    for (int k = -turns; k <= turns; ++k) {
      const float turned_rad = turns > 0 ? half_rad * float(k) / float(turns) : 0;
      const Vec2 turn{std::cos(turned_rad), std::sin(turned_rad)};
      if (finds_any(Vec2{rotations.middle.x * turn.x - rotations.middle.y * turn.y,
                         rotations.middle.x * turn.y + rotations.middle.y * turn.x})) {
        return true;
      }
    }
    return false;
  }

 private:
  bool finds_any(Vec2 direction) const {
    for (float y = 0; y < float(view_.height); y += step_px_) {
      for (float x = 0; x < float(view_.width); x += step_px_) {
        const Vec2 at = view_.origin + Vec2{x, y};
        if (lies_inside({scale_px_ * direction.x, scale_px_ * direction.y, at.x, at.y})) return true;
      }
    }
    return false;
  }

  bool lies_inside(const Similarity& pose) const {
    const float least_px = room_.kept_px - kReachOfAStep * step_px_;
    return std::all_of(points_.begin(), points_.end(), [&](Vec2 point) {
      return field_value(view_, room_.period.wrapped(pose.apply(point))) >= least_px;
    });
  }

  const EmptyRoom& room_;
  FieldView view_;
  std::vector<Vec2> points_;
  float scale_px_;
  float step_px_;
};

/// Whether the piece is too long for a canvas that does not repeat: no piece reaches farther from its centroid than the
/// diagonal.
bool reaches_beyond(const std::vector<Vec2>& points, float scale_px, const EmptyRoom& room) {
  const Grid<float>& nodes = room.distance.value;
  return !room.period.repeats() &&
         scale_px * norm(points.front()) > norm(Vec2{float(nodes.width()), float(nodes.height())});
}

/// Whether the piece would reach its own image on a canvas that repeats.
bool reaches_itself(const std::vector<Vec2>& points, float scale_px, const Period& period) {
  const int shorter_px =
      period.repeats_both_ways() ? std::min(period.x_px, period.y_px) : std::max(period.x_px, period.y_px);
  return period.repeats() && scale_px * norm(points.front()) > float(shorter_px);
}

}  // namespace

bool has_any_place(const Outline& outline, float scale_px, const DirectionRange& rotations, const EmptyRoom& room) {
  std::vector<Vec2> points = some_points(outline);
  if (reaches_beyond(points, scale_px, room) || reaches_itself(points, scale_px, room.period)) return false;
  return PlaceSearch(room, std::move(points), scale_px).finds_any(rotations);
}

}  // namespace tessera
