// Compares regions with the gap and with the elements, by colour and texture.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// Features of `bgr` (CV_8UC3) as CV_32FC(5): lightness relative to its surroundings, L, a, b, and the texture of L.
cv::Mat appearance_features(const cv::Mat& bgr);

/// Whether the pixels of each label (CV_32S) look like those in the mask `gap` rather than those in `element` (CV_8U, not
/// empty). [0] is unused.
std::vector<char> are_like_gap(const cv::Mat& labels, const cv::Mat& features, const cv::Mat& gap,
                               const cv::Mat& element);

}  // namespace tessera
