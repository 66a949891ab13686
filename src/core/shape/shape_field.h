// The distance field that every library shape carries, so that its pieces can be taken out of the free field.
#pragma once

#include "core/shape/shape.h"

namespace tessera {

inline constexpr int kShapeFieldNodes = 128;   // both ways
inline constexpr float kShapeFieldRim = 0.1f;  // between the outline and the grid's edge, shape units

/// Exact distances of the nodes to the outline's polygons, negative inside by the even-odd rule.
ShapeField make_shape_field(const Outline& outline);

/// Half the mean width of the lines that a shape consists of, shape units; infinite where it does not: a disc of a
/// twentieth of its area fits inside. `perimeter` is that of all its curves.
float line_radius(const ShapeField& field, float perimeter);

}  // namespace tessera
