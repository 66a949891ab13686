// A path cut by its clips.
#pragma once

#include "artwork/outlines/layer_paths.h"

namespace tessera {

/// What is seen of the path, in its own units: the path itself, with its curves, where the clips cut nothing off, else
/// polygons and lines that are nowhere farther than `tolerance` from it, filled by the even-odd rule, their coordinates
/// rounded to 1/256, and `is_cut` becomes true. Empty: nothing is seen.
PathSteps clipped(const LayerPath& path, double tolerance, bool& is_cut);

}  // namespace tessera
