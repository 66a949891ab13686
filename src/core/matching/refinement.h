// Refinement of a docking on the free field: Gauss-Newton, then push until no boundary point is too deep.
// kernels/refinement.cl does the same for many at once, bit for bit.
#pragma once

#include "core/field/field_lookup.h"
#include "core/geometry/similarity.h"
#include "core/matching/pose_range.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_model.h"

namespace tessera {

/// One descent as `descent` (tuning.h) says: its steps draw the boundary points onto the free region's boundary. The
/// pose stays in `poses`.
void descend(Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field, const Descent& descent,
             const PoseRange& poses);

/// How deep the piece reaches into what is covered: over the boundary points, px, and kInteriorDepth_px more over
/// the interior points.
float depth_px(const Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field);

/// The whole refinement within `poses`. False where the piece is still deeper than `hard_depth_px`.
bool refine(Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field, const PoseRange& poses,
            float hard_depth_px);

/// Makes the piece larger by kGrowStep at a time, with a descent after each, while it stays feasible; it never becomes
/// smaller.
void grow(Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field, const PoseRange& poses,
          float hard_depth_px);

}  // namespace tessera
