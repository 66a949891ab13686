// The regions of a canvas file, by their colours.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/field/canvas.h"
#include "io/job/job_file.h"

namespace tessera::io {

/// The distance to the edge of each region of the spec, in their order; none where the spec has none. `page`: straight
/// BGRA, `coverage` as mask_coverage gives it. Throws InputError where a region has no place in the file.
std::vector<CanvasField> region_distances(const cv::Mat& page, const Grid<float>& coverage, const CanvasSpec& spec);

}  // namespace tessera::io
