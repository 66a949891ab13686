// The similarity transform that best maps some points to others.
#pragma once

#include <span>

#include "core/geometry/similarity.h"

namespace tessera {

struct PointFit {
  Similarity query_from_shape;
  float residual = 0;  // root mean square, as a fraction of the query points' own spread
};

/// Least squares over corresponding points, at least 2 (Umeyama 1991, without reflections). The residual is 1 if all
/// points of one side coincide.
PointFit fit_points(std::span<const Vec2> shape, std::span<const Vec2> query);

}  // namespace tessera
