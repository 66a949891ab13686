// Makes a piece of a candidate: moves it clear of what was placed since it was refined, grows it, and checks it against the
// outlines of its neighbours.
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

  /// Moves the pose to a near one within `poses` where the shape may stand. False where it finds none.
  bool settle(ShapeId shape, const PoseRange& poses, Similarity& canvas_from_shape);

 private:
  /// The depth, px, to which boundary points of the shape may lie in other pieces.
  float hard_depth_of(const Shape& shape, float scale_px) const;
  bool push_clear(const ShapeModel& model, const PoseRange& poses, float most_px, Similarity& pose) const;
  bool fit_exactly(const Shape& shape, const PoseRange& poses, Similarity& pose) const;

  ShapeSource& shapes_;
  const FreeField& free_;
  const PlacedOutlines& outlines_;
  const MatchingContext& context_;
};

}  // namespace tessera::master
