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

/// The distance, px, that no point of a piece exceeds in one descent from a pose within its range. `least_radius_px`: of the
/// piece at its smallest size.
float longest_way_px(const Descent& descent, float least_radius_px);

/// Depth of the piece in the covered area, px: the largest depth of a boundary point, or of an interior point plus
/// kInteriorDepth_px. 0 if no point is covered.
float depth_px(const Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field);

/// The whole refinement within `poses`. False if the piece ends deeper than `hard_depth_px`.
bool refine(Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field, const PoseRange& poses,
            float hard_depth_px);

/// Enlarges the piece by kGrowStep, with a descent after it. False, and no change, where it cannot grow or would not stay
/// feasible.
bool grow_step(Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field, const PoseRange& poses,
               float hard_depth_px);

}  // namespace tessera
