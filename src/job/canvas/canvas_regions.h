// The regions of a canvas file, recognised by their colours.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/field/canvas.h"
#include "job/canvas/canvas_page.h"
#include "job/job_file.h"

namespace tessera {

/// Label of a pixel that belongs to no region.
inline constexpr int kNoRegion = -1;

/// The region of each pixel of a page (straight BGRA), CV_16S. On an opaque page the prevailing colour along its edge
/// is the background, unless it is the colour of a region.
cv::Mat_<short> region_labels(const cv::Mat& page, const CanvasSpec& spec);

/// Coverage 0..1 of each pixel: the pixels that belong to any region.
Grid<float> region_coverage(const cv::Mat& page, const cv::Mat_<short>& labels);

/// The regions of the spec in their order; empty where it has none. Throws InputError where a region has no pixel in
/// the page, or where all regions together would take gigabytes.
std::vector<CanvasRegion> canvas_regions(const CanvasPage& page, const cv::Mat_<short>& labels, const CanvasSpec& spec);

}  // namespace tessera
