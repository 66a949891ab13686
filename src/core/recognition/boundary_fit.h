// How closely a shape that is laid onto a query follows the query's curves, and the pose in which it follows them best.
#pragma once

#include <span>

#include "core/geometry/similarity.h"
#include "core/recognition/query.h"

namespace tessera {

/// Boundary points of a shape with their unit tangents, shape frame; `spacing`: of neighbours.
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

/// Moves the pose so that those of the shape's points that lie near the query's curves lie on them: `steps` steps of
/// Gauss and Newton, during which the distance up to which points count falls from `reach` to `least_reach` (query units).
/// The scale stays within its limits.
Similarity refined_pose(const Query& query, const BoundaryPoints& shape, Similarity query_from_shape, int steps,
                        float reach, float least_reach, const ScaleLimits& scales);

/// How much of the query's length the shape's boundary follows, 0 to about 1. A point of the boundary counts where the
/// query's curve near it runs in the same direction, the more the closer it is (closeness()): the shape itself differs by
/// what pixels cost, another one of its kind by a few times that.
float followed_part(const Query& query, const BoundaryPoints& shape, const Similarity& query_from_shape);

/// A quick measure of the same kind, by some of the points, to sort poses before they are refined.
float roughly_followed(const Query& query, const BoundaryPoints& shape, const Similarity& query_from_shape);

/// How much a point counts that lies so far from the query's curves: 1 on them, falling to 0.
float closeness(const Query& query, float distance);

/// Whether the pose lays a shape nearly where one of the others lays it: refinement makes one of both.
bool is_nearly_one_of(std::span<const Similarity> others, const Similarity& pose, const Query& query);

}  // namespace tessera
