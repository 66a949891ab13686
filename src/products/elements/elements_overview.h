// The picture that shows what was found in a photograph.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/elements/photo_elements.h"

namespace tessera {

/// The photo, paler, with the outline of each element and its number, from 1 in their order: CV_8UC3, as large as the
/// photo, but 16 megapixels at most.
cv::Mat elements_overview(const cv::Mat& photo, const LabelRuns& labels, const std::vector<PhotoElement>& elements);

}  // namespace tessera
