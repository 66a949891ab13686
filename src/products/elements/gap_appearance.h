// How the gap looks and how the elements do: colour and texture.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// `bgr`: CV_8UC3. CV_32FC(5): lightness by its surroundings, L, a, b, and the texture of L.
cv::Mat appearance_features(const cv::Mat& bgr);

/// For each label (CV_32S) whether its pixels look like those in the mask `gap` rather than those in `element` (CV_8U,
/// neither is empty). [0] is unused.
std::vector<char> are_like_gap(const cv::Mat& labels, const cv::Mat& features, const cv::Mat& gap,
                               const cv::Mat& element);

}  // namespace tessera
