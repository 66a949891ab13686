// Curves painted into a part of a picture. What a pixel gets does not depend on how the picture is divided into parts.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/geometry/vec2.h"

namespace tessera::io {

using Curves = std::vector<std::vector<Vec2>>;  // closed

/// How much of each pixel of the picture's `window` the curves fill, even-odd: 0 to 255, CV_8U.
cv::Mat filled_coverage(const Curves& curves, const Similarity& picture_from_curves, const cv::Rect& window);

}  // namespace tessera::io
