// A path cut by its clips.
#pragma once

#include "artwork/outlines/layer_paths.h"

namespace tessera {

/// The part of the path that its clips let through. Where they cut nothing off it is the path itself, with its curves.
/// Where they cut, the result is polygons and lines, filled by the even-odd rule, nowhere farther than `tolerance` from the path, their
/// coordinates rounded to 1/256. It has no steps where nothing is seen.
LayerPath clipped(LayerPath path, double tolerance);

}  // namespace tessera
