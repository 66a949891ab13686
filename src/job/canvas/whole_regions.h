// Regions of a page without the mixed colours between them.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// A pixel on the border of two regions whose colour is a mixture of both.
struct BorderPlace {
  cv::Point at;
  short first = 0;  // the region with the smaller number
  short second = 0;
  float second_share = 0;  // share of `second` in the colour, 0 to 1
};

struct WholeRegions {
  cv::Mat_<short> labels;
  std::vector<BorderPlace> borders;
};

/// Extends the regions of region_labels (canvas_regions.h) to the whole page. A pixel is certain if all its neighbours
/// have its label. Every other pixel, where colours mix or outside all regions, joins the region of the nearest certain
/// pixel. A label without a certain pixel is lost; without any certain pixel there are no regions (kNoRegion).
WholeRegions whole_regions(const cv::Mat_<short>& labels, const cv::Mat& page_bgra);

}  // namespace tessera
