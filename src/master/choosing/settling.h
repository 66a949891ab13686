// Makes a piece of a candidate: moves it clear of what was placed since it was refined, grows it, and checks it against the
// outlines of its neighbours.
#pragma once

#include "core/collage/placed_outlines.h"
#include "core/field/free_field.h"
#include "core/geometry/similarity.h"
#include "core/matching/matching_context.h"
#include "core/shape/shape.h"
#include "core/shape/shape_model.h"

namespace tessera::master {

/// Where a shape comes to stand.
struct SettledPose {
  bool fits = false;
  Similarity canvas_from_shape;
  Window read;  // the nodes that were read, and those round the outlines that were compared
};

class Settling {
 public:
  /// All arguments outlive it.
  Settling(const FreeField& free, const PlacedOutlines& outlines, const MatchingContext& context)
      : free_(free),
        outlines_(outlines),
        context_(context) {}

  /// Finds a pose within `poses`, near to `canvas_from_shape`, where the shape may stand. Several threads may call it at a
  /// time.
  SettledPose settle(const Shape& shape, const ShapeModel& model, const PoseRange& poses,
                     const Similarity& canvas_from_shape) const;

 private:
  class Attempt;

  const FreeField& free_;
  const PlacedOutlines& outlines_;
  const MatchingContext& context_;
};

}  // namespace tessera::master
