// The regions of a canvas file, by their colours.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/field/canvas.h"
#include "io/job/job_file.h"

namespace tessera::io {

/// The places of a page (straight BGRA) that belong to a region, as coverage 0..1 of each pixel, the sizes rounded up to
/// even ones. On an opaque page the colour that prevails along its edge is the background, unless it is a region's.
Grid<float> region_coverage(const cv::Mat& page, const CanvasSpec& spec);

/// The regions of the spec, in their order; none where the spec has none. Throws InputError where a region has no place
/// in the page.
std::vector<CanvasRegion> canvas_regions(const cv::Mat& page, const CanvasSpec& spec);

}  // namespace tessera::io
