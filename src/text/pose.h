// Where a piece lies as files say it: in px and degrees.
#pragma once

#include "core/geometry/similarity.h"

namespace tessera {

/// Of lengths, and of a turn's degrees.
inline constexpr int kPixelDecimals = 3;

/// canvas_from_shape of a piece of that size, turned clockwise on the picture, with its centre at (x, y).
Similarity pose_of(double scale_px, double rotation_deg, double x_px, double y_px);

/// Clockwise on the picture, in (-180, 180].
double rotation_deg(const Similarity& canvas_from_shape);

}  // namespace tessera
