// Silhouettes in a folder, as in test sets of shape recognition: white on black, one in each file.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace tessera::bench {

struct Silhouette {
  std::string name;  // file name without extension
  cv::Mat mask;      // CV_8U: 255 inside, else 0
};

/// The largest connected part that is lighter than half, as a mask with a margin of clear pixels. `grey`: CV_8U. Empty
/// where nothing is that light.
cv::Mat largest_part(const cv::Mat& grey);

/// The silhouettes of all PNGs in a folder, in the order of their names. Throws InputError where the folder has none,
/// or where one of them is no picture or empty.
std::vector<Silhouette> read_silhouettes(const std::string& folder);

/// The class of a silhouette: its name before the last dash, or the whole name. "Bone-12" belongs to the class "Bone".
std::string class_of(const Silhouette& silhouette);

/// The first silhouette of each class, in their order.
std::vector<Silhouette> first_of_each_class(std::vector<Silhouette> silhouettes);

}  // namespace tessera::bench
