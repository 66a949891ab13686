// The distance at which rows or columns of elements repeat in a photo: of tiles both ways, of bricks from row to row.
#pragma once

#include <opencv2/core.hpp>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// From column to column and from row to row, px of the photo; 0 where elements do not lie in such lines, or where they are
/// turned. `element_px`: the side of a mean element.
cv::Size2d element_pitch_px(const LabelRuns& labels, double element_px);

}  // namespace tessera
