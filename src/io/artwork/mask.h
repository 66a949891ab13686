// The silhouette of a two-colour image without transparency.
#pragma once

#include <opencv2/core.hpp>

namespace tessera::io {

/// `bgr`: CV_8UC3. The background is the colour that prevails along the edge; Otsu's threshold on the difference from
/// it finds the shape. Returns straight BGRA whose alpha rises from 0 at the background's mean difference to 1 at the
/// shape's, so that an antialiased edge keeps its sub-pixel place; its colours have the background taken out. Where
/// nothing differs, alpha is 0 everywhere.
cv::Mat cut_from_background(const cv::Mat& bgr);

}  // namespace tessera::io
