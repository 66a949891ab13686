// The pose of a piece as files state it: in px and degrees.
#pragma once

#include "core/geometry/similarity.h"

namespace tessera {

/// Decimals of lengths in px and of rotations in degrees.
inline constexpr int kPixelDecimals = 3;

/// canvas_from_shape of a piece with this size, rotation (clockwise on the picture) and centre (x, y).
Similarity pose_of(double scale_px, double rotation_deg, double x_px, double y_px);

/// The rotation in degrees, clockwise on the picture, in (-180, 180].
double rotation_deg(const Similarity& canvas_from_shape);

}  // namespace tessera
