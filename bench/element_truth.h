// Compares the elements that were found in a photo with a truth map: elements marked by hand (bench/truth). The benchmark
// element_bench prints the counts. Source of the ideas of split and merged regions: A. Hoover and others, "An experimental
// comparison of range image segmentation algorithms", 1996.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "products/elements/photo_elements.h"
#include "products/elements/photo_extraction.h"
#include "products/elements/segmentation/label_runs.h"

namespace tessera::bench {

// Labels of a truth map. 0 is ground, 1 to kMostWhole are whole elements, and those from kFirstIgnored on are ignored:
// elements that the photo's edge cuts, tiny filler, and places where one cannot tell what one element is.
inline constexpr int kMostWhole = 999;
inline constexpr int kFirstIgnored = 1001;
/// The label of pixels outside the crops that were marked. They are ignored, too.
inline constexpr int kUnmarked = 65535;

/// Least intersection over union of a found element and a whole element that match.
inline constexpr double kLeastMatch = 0.5;

/// A found element and the whole element that it matches.
struct TruthMatch {
  int truth = 0;            // its label
  std::size_t element = 0;  // index of the found element
  double overlap = 0;       // intersection over union
};

struct TruthComparison {
  std::vector<int> whole;            // labels of all whole elements, in order
  std::vector<char> is_counted;      // of each found element: it does not lie mostly in ignored pixels
  std::vector<TruthMatch> by_boxes;  // one to one, the greatest overlaps of bounding boxes first
  std::vector<TruthMatch> by_masks;  // one to one, the greatest overlaps of pixels first
  std::vector<int> split;            // whole elements in which two or more counted elements mostly lie
  std::vector<std::size_t> merged;   // counted elements in which two or more whole elements mostly lie

  std::size_t counted() const;
};

/// "Mostly" means more than half of the pixels. `truth`: CV_32S of the size of `labels`. `elements`: those that were found,
/// without the ones that the photo's edge cuts (find_elements()). Elements that are not counted match nothing.
TruthComparison compared_with_truth(const cv::Mat& truth, const LabelRuns& labels,
                                    const std::vector<PhotoElement>& elements);

/// Throws InputError where a pixel of the map has no label of a truth map. `path`: of its file, for the message.
void check_truth(const cv::Mat& truth, const std::string& path);

/// The elements found in a photo, and how they agree with the truth.
struct PhotoComparison {
  Extraction extraction;
  cv::Mat truth;  // the map, enlarged like the photo
  TruthComparison comparison;
  double processor_s = 0;  // of this process, for the search and for cutting out
};

/// Searches the photo like `tessera texture` (texture_extraction()), without its ground. `truth`: the path of its map, a
/// grey PNG of 8 or 16 bits. `element_px`: short side of an element, px of the photo; 0: found. Throws InputError as
/// extract_elements() does, and where the map has another size than the photo or a label that no truth map has.
PhotoComparison compared_photo(const std::string& photo, const std::string& truth, double element_px, Drawers& drawers);

}  // namespace tessera::bench
