// Elements that lie apart on a plain ground: pieces of a jigsaw on a table, leaves on paper, coins on cloth.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

namespace tessera {

/// A label map (products/elements/segmentation/region_labels.h) in which each part of the photo that stands out from its ground is one
/// region, connected by its pixels' sides and without holes; regions that touch are one. Nothing where the ground is not
/// plain: it must be seen along most of the photo's edge, in one piece round the elements, in one colour but for the
/// light, which may change slowly over the photo, and for noise. Soft shadows count as ground. `photo`: CV_8UC3 or
/// CV_8UC4, BGR first. The map is of the photo's size, or smaller where the photo is larger than 6 megapixels.
std::optional<cv::Mat> elements_on_plain_ground(const cv::Mat& photo);

}  // namespace tessera
