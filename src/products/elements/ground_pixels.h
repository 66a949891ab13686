// Finds the pixels of a photograph that show the ground below its elements: mortar, sand, cloth.
#pragma once

#include <opencv2/core.hpp>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

struct GroundPixels {
  cv::Mat certain;  // CV_8U, 255: ground, but not in the soft edge of an element
  double part = 0;  // part of the photo that is ground, up to the elements' edges
};

/// The pixels that are like the gaps between elements in colour and texture, so that elements that were not found do not
/// count as ground. `photo`: CV_8UC3 or CV_8UC4, BGR first. `labels`: of its size, including elements that the photo's edge
/// cuts. Empty where there are no gaps, or no elements to compare them with.
GroundPixels ground_pixels(const cv::Mat& photo, const LabelRuns& labels);

}  // namespace tessera
