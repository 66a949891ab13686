#include "core/collage/wide_gap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/base/stop.h"
#include "core/geometry/convex_hull.h"
#include "core/shape/shape_field.h"

namespace tessera {
namespace {

constexpr int kNodeStride = 2;
constexpr int kTurns = 32;
constexpr Vec2 kDirectionStep{0.98078528f, 0.19509032f};  // cosine and sine of a 32nd of a whole turn
constexpr std::size_t kPlacesBetweenChecks = 1000;
constexpr float kLeastDistance = 0.5f;  // distance of the hull's middle from anything, in parts of HullRoom::radius
/// Boundary points are tested in strides of this, as neighbouring points mostly hit the same thing. The stride has no
/// divisor in common with the number of points, so that all are tested.
constexpr int kPointStride = 37;

std::array<Vec2, kTurns> directions() {
  std::array<Vec2, kTurns> all;
  Vec2 direction{1, 0};
  for (Vec2& d : all) {
    d = direction;
    direction = {d.x * kDirectionStep.x - d.y * kDirectionStep.y, d.x * kDirectionStep.y + d.y * kDirectionStep.x};
  }
  return all;
}

bool lies_free(const ShapeModel& shape, const Similarity& pose, const FieldView& field) {
  for (int i = 0; i < kBoundaryPoints; ++i) {
    const Vec2 p = shape.boundary[std::size_t(i * kPointStride % kBoundaryPoints)];
    if (field_value(field, pose.apply(p)) < 0) return false;
  }
  return std::all_of(shape.interior.begin(), shape.interior.end(),
                     [&](Vec2 p) { return field_value(field, pose.apply(p)) > 0; });
}

/// The allowed turned poses, with the hull's middle at the origin.
std::vector<Similarity> turned_poses(const HullRoom& room, const PoseRange& poses) {
  std::vector<Similarity> turned;
  for (const Vec2 direction : directions()) {
    Similarity pose{direction.x * poses.min_scale_px, direction.y * poses.min_scale_px, 0, 0};
    if (!poses.rotations.contains(direction, 1, 0)) continue;
    poses.pull_in(pose);
    turned.push_back(pose);
  }
  if (turned.empty()) {  // the middle of a narrow range
    turned.push_back(
        {poses.rotations.middle.x * poses.min_scale_px, poses.rotations.middle.y * poses.min_scale_px, 0, 0});
    poses.pull_in(turned.back());
  }
  for (Similarity& pose : turned) {
    const Vec2 middle = pose.apply(room.middle);
    pose.tx = -middle.x;
    pose.ty = -middle.y;
  }
  return turned;
}

/// Every second node of the window whose distance to anything is at least `least_px`, as canvas px.
std::vector<Vec2> places_of_middle(const FreeField& free, const Window& window, float least_px) {
  const CanvasField& field = free.field();
  std::vector<Vec2> places;
  for (const Window& part : free.grid().images(window, free.grid().one_period())) {
    for (int y = part.y0; y < part.y1; y += kNodeStride) {
      for (int x = part.x0; x < part.x1; x += kNodeStride) {
        if (field.value(x, y) >= least_px) places.push_back(field.origin + Vec2{float(x), float(y)});
      }
    }
  }
  return places;
}

/// A stride that visits all places and keeps successive ones far apart.
std::size_t stride_over(std::size_t places) {
  std::size_t stride = std::max<std::size_t>(1, places * 618 / 1000);
  while (std::gcd(stride, places) != 1) ++stride;
  return stride;
}

}  // namespace

float widest_gap_px(const FreeField& free, const Window& window) {
  const Grid<float>& distance = free.field().value;
  float widest_px = 0;
  for (const Window& part : free.grid().images(window, free.grid().one_period())) {
    for (int y = part.y0; y < part.y1; ++y) {
      const float* row = distance.row(y);
      widest_px = std::max(widest_px, *std::max_element(row + part.x0, row + part.x1));
    }
  }
  return widest_px;
}

HullRoom hull_room(const Shape& shape) {
  const std::vector<Vec2> hull = convex_hull(shape.outline.curves.front());
  const AreaMoment moment = area_moment(hull);
  const Vec2 middle = moment.area > 0 ? Vec2{float(moment.x / moment.area), float(moment.y / moment.area)} : Vec2{};
  const bool of_lines = std::isfinite(line_radius(shape.field, shape.perimeter));
  const float half_width = of_lines ? 0 : float(0.5 * least_width(hull));
  return {middle, float(moment.area), std::max(kLeastWideGap, half_width), of_lines};
}

bool any_pose_in_gap(const ShapeModel& shape, const HullRoom& room, const PoseRange& poses, const FreeField& free,
                     const Window& window, const StopCheck& check_stop,
                     const std::function<bool(const Similarity&)>& attempt) {
  const std::vector<Vec2> middles = places_of_middle(free, window, kLeastDistance * room.radius * poses.min_scale_px);
  const std::vector<Similarity> turned = turned_poses(room, poses);
  const std::size_t stride = stride_over(middles.size());
  for (std::size_t k = 0, at = 0; k < middles.size(); ++k, at = (at + stride) % middles.size()) {
    if (k % kPlacesBetweenChecks == 0) check_stop();
    for (std::size_t turn = 0; turn < turned.size(); ++turn) {
      Similarity pose = turned[(k + turn) % turned.size()];
      pose.tx += middles[at].x;
      pose.ty += middles[at].y;
      if (!lies_free(shape, pose, free.view())) continue;
      if (attempt(pose)) return true;
      break;  // an attempt elsewhere is better than one in another rotation
    }
  }
  return false;
}

}  // namespace tessera
