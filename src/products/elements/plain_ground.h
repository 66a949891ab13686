// Finds elements that lie apart on a plain ground: pieces of a jigsaw on a table, leaves on paper, coins on cloth.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

namespace tessera {

/// A label map (products/elements/segmentation/region_labels.h) of the parts of the photo that differ from its ground. Each
/// is one region without holes, connected by sides of pixels; regions that touch are one. Empty where the ground is not
/// plain. It must be seen along most of the photo's edge, in one piece around the elements, and in one colour; slow changes
/// of light and noise are allowed. Soft shadows count as ground. `photo`: CV_8UC3 or CV_8UC4, BGR first. The map has the
/// photo's size, or less where the photo exceeds 6 megapixels.
std::optional<cv::Mat> elements_on_plain_ground(const cv::Mat& photo);

}  // namespace tessera
