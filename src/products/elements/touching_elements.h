// Finds regions of a map that are several touching elements.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// Whether each label's region, cut at its necks, gives parts of similar thickness, like two coins that touch. [0] is
/// unused.
std::vector<bool> touching_regions(const LabelRuns& labels);

/// Both maps belong to one photo. Returns the regions of `apart`; but a region that `touch` marks is replaced by the
/// regions of `searched` inside it, if there are any. Solid regions stay solid.
LabelRuns with_touching_apart(const LabelRuns& apart, const std::vector<bool>& touch, const LabelRuns& searched);

}  // namespace tessera
