// The distance field of a library shape, used to take its pieces out of the free field.
#pragma once

#include "core/shape/shape.h"

namespace tessera {

inline constexpr int kShapeFieldNodes = 128;   // in each direction
inline constexpr float kShapeFieldRim = 0.1f;  // distance of the outline to the grid's edge, shape units

/// Exact distances of the nodes to the outline's polygons, negative inside by the even-odd rule.
ShapeField make_shape_field(const Outline& outline);

/// Half the mean width of the lines that a shape consists of, shape units. Infinite if it does not consist of lines:
/// then a disc of a twentieth of its area fits inside. `perimeter` is that of all its curves.
float line_radius(const ShapeField& field, float perimeter);

}  // namespace tessera
