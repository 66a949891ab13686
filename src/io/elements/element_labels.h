// Finds the elements of a photograph: stones, tiles, coins, leaves that lie side by side or apart on a ground.
#pragma once

#include <opencv2/core.hpp>

namespace tessera::io {

/// `photo_bgr`: CV_8UC3. `element_px`: short side of a typical element, px of the photo, above 0. Wrong by 1.4 costs
/// little where elements are much alike; where they differ much, rather too small than too large. Labels CV_32SC1 of its size: 0 = gap, 1..n = elements, each one region, connected by its
/// pixels' sides and without holes. The same photo and size give the same labels on any number of threads.
///
/// Works on copies in which an element is 40 and 56 px, the larger of at most 6 megapixels (about 1900 elements,
/// or 3800 smaller ones): a size that needs more is refused, so that memory stays below 2 GB at 50 megapixels.
/// All labels are 0 where nothing is found: in a flat photo, in one smaller than an element.
/// Throws std::invalid_argument if the photo is not CV_8UC3, or if the size is no number above 0 or too small for it.
/// An element that the photo's edge cuts may be missing.
cv::Mat element_labels(const cv::Mat& photo_bgr, double element_px);

}  // namespace tessera::io
