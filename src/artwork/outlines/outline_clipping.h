// A path cut by its clips, and one whose contours cross.
#pragma once

#include "artwork/outlines/layer_paths.h"

namespace tessera {

/// The part of the path that its clips let through. Where they cut nothing off it is the path itself, with its curves.
/// Where they cut, the result is polygons and lines, filled by the even-odd rule, nowhere farther than `tolerance` from the path, their
/// coordinates rounded to 1/256. It has no steps where nothing is seen.
LayerPath clipped(LayerPath path, double tolerance);

/// The path without the parts of its contours that lie in what others of them fill, where contours cross or share an edge: polygons
/// as above. Where none do it is the path itself. A contour that crosses only itself stays.
LayerPath united(LayerPath path, double tolerance);

}  // namespace tessera
