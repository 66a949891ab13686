// Regions of a map that are several elements which touch.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// Of each label whether its region falls into parts that are much alike in thickness where it is cut at its necks, as two
/// coins that touch do. [0] is unused.
std::vector<bool> touching_regions(const LabelRuns& labels);

/// Both maps are of one photo. The regions of `apart`, but those that `touch` marks are replaced by the regions of
/// `searched` that lie in them, where there are such. Solid regions stay solid.
LabelRuns with_touching_apart(const LabelRuns& apart, const std::vector<bool>& touch, const LabelRuns& searched);

}  // namespace tessera
