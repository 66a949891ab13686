// Which pixels of a photograph show the ground that its elements lie on: mortar, sand, cloth.
#pragma once

#include <opencv2/core.hpp>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

struct GroundPixels {
  cv::Mat certain;  // CV_8U, 255: ground, and no part of the soft edge of an element
  double part = 0;  // of the photo that is ground, up to the elements' edges
};

/// What is like the gaps between elements in colour and texture, so that elements which were not found do not count.
/// `photo`: CV_8UC3 or CV_8UC4, BGR first; `labels`: of its size, with those of elements that the photo's edge cuts.
/// Nothing where there are no gaps, or no elements to tell them from.
GroundPixels ground_pixels(const cv::Mat& photo, const LabelRuns& labels);

}  // namespace tessera
