// The width of the remaining gaps, and the width that a gap must have to hold a shape. Line art encloses more than it
// covers.
#pragma once

#include <functional>

#include "core/base/stop.h"
#include "core/field/free_field.h"
#include "core/matching/pose_range.h"
#include "core/shape/shape.h"
#include "core/shape/shape_model.h"

namespace tessera {

/// Radius, px, of the largest disc in the free region around a node of `window` or of its images; at least 0.
float widest_gap_px(const FreeField& free, const Window& window);

/// A gap with a smaller disc radius holds no shape: it is about the radius of a disc of area 1. Shape units.
inline constexpr float kLeastWideGap = 0.56f;

/// The room that a shape takes together with the area it encloses, shape units.
struct HullRoom {
  Vec2 middle;     // the centroid of its convex hull
  float area = 0;  // of the hull; that of the shape is 1
  /// Disc radius of a gap that is wide enough: half of the hull's smallest width, but at least kLeastWideGap. For
  /// shapes of lines it is kLeastWideGap, since these may lie around other pieces.
  float radius = 0;
  bool of_lines = false;  // line_radius() is finite

  /// Whether dockings hardly find a pose for the shape. Such a shape is thin, or it encloses at least as much as it
  /// covers, as frames, rings and suns with rays do.
  bool hardly_docks() const { return of_lines || area >= 2; }
};
HullRoom hull_room(const Shape& shape);

/// Tries poses of the smallest size of `poses` in which the shape lies in the free region. Returns true as soon as
/// `attempt` returns true for one. The hull's middle is put on every second node of `window`, in a scattered order. A
/// node must have at least half of the distance that the middle of a wide enough gap has. Of 32 rotations at a node the
/// first in which the shape lies free is attempted. Calls `check_stop` regularly, which may throw.
bool any_pose_in_gap(const ShapeModel& shape, const HullRoom& room, const PoseRange& poses, const FreeField& free,
                     const Window& window, const StopCheck& check_stop,
                     const std::function<bool(const Similarity&)>& attempt);

}  // namespace tessera
