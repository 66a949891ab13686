// Cuts a path by its clips, and joins contours that cross.
#pragma once

#include "artwork/outlines/layer_paths.h"

namespace tessera {

/// The part of the path inside its clips. Where they cut nothing off it is the path itself, with its curves. Where they
/// cut, the result is polygons and lines with the even-odd rule, at most `tolerance` away from the path, with
/// coordinates rounded to 1/256. It has no steps where nothing is visible.
LayerPath clipped(LayerPath path, double tolerance);

/// The path without the parts of its contours that lie inside other contours, where contours cross or share an edge:
/// polygons as above. Where no contours cross it is the path itself. A contour that crosses only itself stays.
LayerPath united(LayerPath path, double tolerance);

}  // namespace tessera
