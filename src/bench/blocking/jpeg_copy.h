// Writes a mask as a JPEG and reads it back, with the noise that the compression adds.
#pragma once

#include <opencv2/core.hpp>

namespace tessera::bench {

/// The mask (CV_8U) after it was encoded with this quality, 1 to 100, and decoded. Throws InputError where a side is
/// longer than a JPEG's may be (65,500 px).
cv::Mat jpeg_copy(const cv::Mat& mask, int quality);

}  // namespace tessera::bench
