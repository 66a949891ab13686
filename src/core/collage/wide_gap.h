// How wide the gaps are that are left, and how wide one must be to hold a shape: line art encloses more than it covers.
#pragma once

#include <functional>

#include "core/base/stop.h"
#include "core/field/free_field.h"
#include "core/matching/pose_range.h"
#include "core/shape/shape.h"
#include "core/shape/shape_model.h"

namespace tessera {

/// Radius, px, of the largest disc in the free region round a node of `window`, or of an image of it; not below 0.
float widest_gap_px(const FreeField& free, const Window& window);

/// No gap is wide enough for a shape whose radius is less than that of a disc of the shape's area, shape units.
inline constexpr float kLeastWideGap = 0.56f;

/// The place that a shape takes with all that it encloses, shape units.
struct HullRoom {
  Vec2 middle;     // the centroid of its convex hull
  float area = 0;  // of the hull; that of the shape is 1
  /// Of a gap that is wide enough: half of the hull's width where it is narrowest, and kLeastWideGap at least. The latter
  /// where the shape consists of lines: these may lie round others.
  float radius = 0;
  bool of_lines = false;  // line_radius() is finite

  /// Dockings hardly find a pose for it: it encloses at least as much as it covers, as frames, rings and suns with rays
  /// do, or it is thin.
  bool hardly_docks() const { return of_lines || area >= 2; }
};
HullRoom hull_room(const Shape& shape);

/// `check_stop` is called again and again, and may throw. Whether `attempt` returns true for a pose of the smallest size of `poses` in which the shape lies in the free
/// region. The hull's middle lies at every second node of `window`, in a scattered order, that is at least half as
/// far from anything as the middle of a gap that is wide enough; of 32 rotations there the first is attempted in which the
/// shape lies free.
bool any_pose_in_gap(const ShapeModel& shape, const HullRoom& room, const PoseRange& poses, const FreeField& free,
                     const Window& window, const StopCheck& check_stop,
                     const std::function<bool(const Similarity&)>& attempt);

}  // namespace tessera
