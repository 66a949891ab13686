// Measures how closely a posed shape follows the curves of a query, and finds the pose in which it follows them best.
#pragma once

#include <span>

#include "core/geometry/similarity.h"
#include "core/recognition/query.h"

namespace tessera {

/// Boundary points of a shape with their unit tangents, shape frame; `spacing`: distance of neighbours.
struct BoundaryPoints {
  std::span<const Vec2> position;
  std::span<const Vec2> tangent;
  float spacing = 0;
};

/// Scales, query units for one shape unit.
struct ScaleLimits {
  float least = 0;
  float most = 0;
};

/// Moves the pose so that shape points near the query's curves lie on them, by `steps` Gauss-Newton steps. Points count
/// up to a distance that falls from `reach` to `least_reach` (query units). The scale stays within its limits.
Similarity refined_pose(const Query& query, const BoundaryPoints& shape, Similarity query_from_shape, int steps,
                        float reach, float least_reach, const ScaleLimits& scales);

/// The fraction of the query's length that the shape's boundary follows, 0 to about 1. A boundary point counts if the
/// query's curve near it has the same direction, and counts more the closer it is (closeness()). The errors of pixels
/// cost the right shape little; another shape of its kind differs by a few times as much.
float followed_part(const Query& query, const BoundaryPoints& shape, const Similarity& query_from_shape);

/// A fast estimate of the same kind from some of the points, to sort poses before they are refined.
float roughly_followed(const Query& query, const BoundaryPoints& shape, const Similarity& query_from_shape);

/// The weight of a point at this distance from the query's curves: 1 on them, falling to 0.
float closeness(const Query& query, float distance);

/// Whether the pose is nearly equal to one of the others, so that refinement would make one of both.
bool is_near_any_pose(std::span<const Similarity> others, const Similarity& pose, const Query& query);

}  // namespace tessera
