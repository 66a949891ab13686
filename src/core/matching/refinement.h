// Refinement of a docking on the free field: Gauss-Newton, then push until no boundary point is too deep (design,
// method 6). kernels/refinement.cl does the same for many at once, bit for bit.
#pragma once

#include "core/field/field_lookup.h"
#include "core/geometry/similarity.h"
#include "core/matching/matching_context.h"
#include "core/shape/shape_model.h"

namespace tessera {

/// One descent: `steps` Gauss-Newton steps that draw boundary points nearer than a radius (shrinking from
/// `first_radius_px` to `last_radius_px`) onto the free region's boundary; a point outside weighs `overlap_weight`. The pose stays in `poses`.
struct Descent {
  int steps;
  float first_radius_px;
  float last_radius_px;
  float overlap_weight;
  int stride;  // through the boundary points: kMediumStride or 1
};

void descend(Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field, const Descent& descent,
             const PoseRange& poses);

/// How deep the piece reaches into what is covered: over the boundary points, px, and 3 px more for interior points,
/// which only something thin and so certainly visible can reach.
float depth_px(const Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field);

/// The whole refinement. False where the piece is still too deep, too small or turned too far.
bool refine(Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field,
            const MatchingContext& context);

/// Larger by kGrowStep while feasible (design, method 9: grow, never shrink).
void grow(Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field,
          const MatchingContext& context);

}  // namespace tessera
