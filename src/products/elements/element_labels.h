// Finds the elements of a photograph: stones, tiles, coins or leaves, close together or apart on a ground.
#pragma once

#include <opencv2/core.hpp>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// Copies of a photo in which an element is 40 and 56 px wide, at most 6 megapixels for the larger one (about 1900
/// elements, or 3800 smaller ones). The search needs only these, so the photo itself need not be in memory.
struct ElementCopies {
  cv::Mat coarse, fine;  // CV_8UC3; empty: the photo is smaller than an element
};

/// Makes the copies. `photo`: CV_8UC3 or CV_8UC4, BGR first. `element_px`: short side of a typical element, px of the
/// photo, above 0. An error of 1.4 times costs little where elements are much alike. Where they differ much, choose it too
/// small rather than too large. Throws std::invalid_argument if the photo has another format, or the size is not above 0 or
/// too small for the photo.
ElementCopies element_copies(const cv::Mat& photo, double element_px);

/// A label map of the finer copy (region_labels.h). Each element is one region without holes, connected by sides of pixels.
/// The same photo and size give the same labels on any number of threads. It takes at most 300 MB. All labels are 0 where
/// it finds nothing: in a flat photo, or in one smaller than an element.
cv::Mat elements_in_copies(const ElementCopies& copies);

/// The labels of the photo, from those of its finer copy. An element that the photo's edge cuts may be missing.
LabelRuns labels_of_photo(const cv::Mat& photo, const cv::Mat& in_copy);

/// All three steps.
LabelRuns element_labels(const cv::Mat& photo, double element_px);

}  // namespace tessera
