// Regions of a page without what blurs between them.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// A place on the border of two regions, in whose colour both have a share.
struct BorderPlace {
  cv::Point at;
  short first = 0;  // of the two regions, the one with the smaller number
  short second = 0;
  float second_share = 0;  // 0 to 1
};

struct WholeRegions {
  cv::Mat_<short> labels;
  std::vector<BorderPlace> borders;
};

/// The regions of region_labels (canvas_regions.h), so that every place of the page is in one: where two colours mix,
/// and outside all of them, each place is in the region that is nearest for certain, as its neighbours are of that
/// region, too. Labels that are nowhere certain are lost; without any that is, there are no regions (kNoRegion).
WholeRegions whole_regions(const cv::Mat_<short>& labels, const cv::Mat& page_bgra);

}  // namespace tessera
