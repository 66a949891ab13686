// Embeds pictures in documents.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace tessera {

/// A data: URI that holds the straight BGRA picture as PNG.
std::string png_uri(const cv::Mat& bgra);

}  // namespace tessera
