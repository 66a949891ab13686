// The scales at which the shapes of a library may lie on a query.
#pragma once

#include <optional>

#include "core/recognition/boundary_fit.h"
#include "core/recognition/known_shapes.h"
#include "core/recognition/query.h"

namespace tessera {

class PossibleScales {
 public:
  /// `shapes`: at least one. `query_per_drawn_px`: query units for one px of the library's drawings, if known; then
  /// each shape has its drawn scale. Otherwise shapes may be from a fraction of the query's size to somewhat larger
  /// than it.
  PossibleScales(const Query& query, const KnownShapes& shapes, std::optional<float> query_per_drawn_px);

  std::optional<float> query_per_drawn_px() const { return query_per_drawn_px_; }
  /// The least and the largest scale of any of the shapes.
  const ScaleLimits& limits() const { return limits_; }
  /// Whether this shape may have one of these scales, which are an estimate from key points.
  bool may_have(std::uint32_t shape, const ScaleLimits& scales) const;
  /// The scales that a pose near this one may have.
  ScaleLimits near(std::uint32_t shape, const Similarity& query_from_shape) const;

 private:
  float known(std::uint32_t shape) const { return shapes_.drawn_scale_px(shape) * *query_per_drawn_px_; }

  const KnownShapes& shapes_;
  std::optional<float> query_per_drawn_px_;
  ScaleLimits limits_;
};

}  // namespace tessera
