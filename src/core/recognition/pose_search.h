// Poses in which shapes of a library may lie on a query, by the PADs of both (paper, section 3.3).
#pragma once

#include <optional>
#include <vector>

#include "core/recognition/boundary_fit.h"
#include "core/recognition/known_shapes.h"
#include "core/recognition/query.h"

namespace tessera {

struct PosedShape {
  std::uint32_t shape = 0;  // of KnownShapes
  Similarity query_from_shape;
  float followed = 0;  // how good the pose is, by whatever measure was last taken
};

/// The scales at which a shape is looked for near a pose. `query_per_drawn_px`: where it is known, shapes have their drawn
/// scale.
ScaleLimits scale_limits(const KnownShapes& shapes, const PosedShape& posed, std::optional<float> query_per_drawn_px);

/// One pose for each pair of a PAD of the query and one of its nearest in the library whose key points agree. Smoothing by
/// one width on the query's side and one of kSmoothingLevels on the shape's belong to scales of half an octave, as curves
/// agree only where they are smoothed alike.
std::vector<PosedShape> posed_shapes(const Query& query, const KnownShapes& shapes,
                                     std::optional<float> query_per_drawn_px);

}  // namespace tessera
