// Finds the elements of a photograph: stones, tiles, coins, leaves that lie side by side or apart on a ground.
#pragma once

#include <opencv2/core.hpp>

#include "products/elements/segmentation/label_runs.h"

namespace tessera {

/// Copies of a photo in which an element is 40 and 56 px, the larger of at most 6 megapixels (about 1900 elements, or
/// 3800 smaller ones): all that the search needs, so that the photo itself need not be held meanwhile.
struct ElementCopies {
  cv::Mat coarse, fine;  // CV_8UC3; empty: the photo is smaller than an element
};

/// `photo`: CV_8UC3 or CV_8UC4, BGR first. `element_px`: short side of a typical element, px of the photo, above 0. Wrong
/// by 1.4 costs little where elements are much alike; where they differ much, rather too small than too large. Throws
/// std::invalid_argument if the photo is of another kind, or if the size is no number above 0, or too small for it.
ElementCopies element_copies(const cv::Mat& photo, double element_px);

/// A label map of the finer copy (region_labels.h), in which each element is one region, connected by its pixels' sides
/// and without holes. The same photo and size give the same labels on any number of threads. Takes 300 MB at most. All
/// labels are 0 where nothing is found: in a flat photo, in one smaller than an element.
cv::Mat elements_in_copies(const ElementCopies& copies);

/// Of the photo, from those of its finer copy. An element that the photo's edge cuts may be missing.
LabelRuns labels_of_photo(const cv::Mat& photo, const cv::Mat& in_copy);

/// All three.
LabelRuns element_labels(const cv::Mat& photo, double element_px);

}  // namespace tessera
