// Refinement of a docking on the free field: Gauss-Newton steps, then pushing until no boundary point is too deep.
// kernels/refinement.cl does the same for many at once, bit for bit.
#pragma once

#include "core/field/field_lookup.h"
#include "core/geometry/similarity.h"
#include "core/matching/pose_range.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_model.h"

namespace tessera {

/// One descent with the parameters of `descent` (tuning.h): its steps pull the boundary points onto the free region's
/// boundary. The pose stays in `poses`.
void descend(Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field, const Descent& descent,
             const PoseRange& poses);

/// Depth of the piece in the covered area, px: the largest depth of a boundary point, or of an interior point plus
/// kInteriorDepth_px. 0 if no point is covered.
float depth_px(const Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field);

/// The whole refinement within `poses`. False if the piece ends deeper than `hard_depth_px`.
bool refine(Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field, const PoseRange& poses,
            float hard_depth_px);

/// Enlarges the piece in steps of kGrowStep, with a descent after each, while it stays feasible. The piece never
/// becomes smaller.
void grow(Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field, const PoseRange& poses,
          float hard_depth_px);

}  // namespace tessera
