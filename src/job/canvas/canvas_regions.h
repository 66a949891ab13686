// The regions of a canvas file, by their colours.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/field/canvas.h"
#include "job/canvas/canvas_page.h"
#include "job/job_file.h"

namespace tessera {

/// What belongs to no region.
inline constexpr int kNoRegion = -1;

/// For each place of a page (straight BGRA) the region that it belongs to, CV_16S. On an opaque page the colour that
/// prevails along its edge is the background, unless it is a region's.
cv::Mat_<short> region_labels(const cv::Mat& page, const CanvasSpec& spec);

/// The places that belong to a region, as coverage 0..1 of each pixel.
Grid<float> region_coverage(const cv::Mat& page, const cv::Mat_<short>& labels);

/// The regions of the spec, in their order; none where the spec has none. Throws InputError where a region has no place
/// in the page, or where all of them together would take gigabytes.
std::vector<CanvasRegion> canvas_regions(const CanvasPage& page, const cv::Mat_<short>& labels, const CanvasSpec& spec);

}  // namespace tessera
