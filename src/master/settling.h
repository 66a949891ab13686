// How a candidate becomes a piece: made clear of what was placed since it was refined, grown, and held against its
// neighbours' outlines.
#pragma once

#include "core/collage/placed_outlines.h"
#include "core/field/free_field.h"
#include "core/geometry/similarity.h"
#include "core/matching/matching_context.h"
#include "core/shape/shape_source.h"

namespace tessera::master {

class Settling {
 public:
  /// All arguments outlive it.
  Settling(ShapeSource& shapes, const FreeField& free, const PlacedOutlines& outlines, const MatchingContext& context)
      : shapes_(shapes),
        free_(free),
        outlines_(outlines),
        context_(context) {}

  /// Moves the pose to where the shape may stand, near by and within `poses`. False where it may not stand.
  bool settle(ShapeId shape, const PoseRange& poses, Similarity& canvas_from_shape);

 private:
  /// How deep its boundary points may lie in other pieces.
  float hard_depth_of(const Shape& shape, float scale_px) const;
  bool push_clear(const ShapeModel& model, const PoseRange& poses, float most_px, Similarity& pose) const;
  bool fit_exactly(const Shape& shape, const PoseRange& poses, Similarity& pose) const;

  ShapeSource& shapes_;
  const FreeField& free_;
  const PlacedOutlines& outlines_;
  const MatchingContext& context_;
};

}  // namespace tessera::master
