// Draws the elements that were found in a photograph.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/photo_elements.h"

namespace tessera {

/// The paler photo with the outline of each element and its number, from 1 in their order. CV_8UC3, as large as the photo,
/// but at most 16 megapixels.
cv::Mat elements_overview(const cv::Mat& photo, const LabelRuns& labels, const std::vector<PhotoElement>& elements);

}  // namespace tessera
