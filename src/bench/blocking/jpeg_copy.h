// Encodes a mask as JPEG and decodes it, which adds the noise of the compression.
#pragma once

#include <opencv2/core.hpp>

namespace tessera::bench {

/// The mask (CV_8U) after encoding with this quality, 1 to 100, and decoding. Throws InputError where a side is longer
/// than a JPEG allows (65,500 px).
cv::Mat jpeg_copy(const cv::Mat& mask, int quality);

}  // namespace tessera::bench
