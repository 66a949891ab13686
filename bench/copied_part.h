// How much of a texture comes again: what people see first of image quilting.
#pragma once

#include <opencv2/core.hpp>

namespace tessera::bench {

/// The part of the picture's squares (of that side, each half a side from the next) that come again at another place, not
/// nearer than a side: 0 to 1. A square comes again where its correlation with the picture in grey is at least 0.9. `bgr`:
/// CV_8UC3. 0 where the picture is not as large as two squares.
double copied_part(const cv::Mat& bgr, int square_px);

}  // namespace tessera::bench
