// Which pixels of a photograph show the ground that its elements lie on: mortar, sand, cloth.
#pragma once

#include <opencv2/core.hpp>

namespace tessera::io {

struct GroundPixels {
  cv::Mat certain;  // CV_8U, 255: ground, and no part of the soft edge of an element
  double part = 0;  // of the photo that is ground, up to the elements' edges
};

/// What is like the gaps between elements in colour and texture, so that elements which were not found do not count.
/// `photo_bgr`: CV_8UC3; `labels`: CV_32SC1 of its size, 0 = gap, with those of elements that the photo's edge cuts.
/// Nothing where there are no gaps, or no elements to tell them from.
GroundPixels ground_pixels(const cv::Mat& photo_bgr, const cv::Mat& labels);

}  // namespace tessera::io
