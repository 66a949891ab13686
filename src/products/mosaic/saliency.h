// Saliency: the places of a picture that people look at first, whatever the contrast is there. These are faces, or what the
// user has painted in a map.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "products/mosaic/face_search.h"

namespace tessera {

/// The saliency of faces, CV_32F of `size`, 0..1: eyes and mouths have most, then faces, with soft borders. It is less for
/// faces so large that larger pieces show them, too. `smallest_px`: size of the smallest piece, px of the result.
cv::Mat saliency_of_faces(const std::vector<Face>& faces, cv::Size size, double smallest_px);

/// The saliency from a grey picture, straight BGRA (CV_8UC4) of any size: black and transparent = 0, white = 1. Throws
/// InputError where the picture has colours.
cv::Mat saliency_of_picture(const cv::Mat& bgra, cv::Size size);

}  // namespace tessera
