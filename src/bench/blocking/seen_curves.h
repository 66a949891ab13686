// Queries made of masks: what is seen of a silhouette is drawn anew in pixels and traced, and edges of what hides the rest
// are cut out.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <vector>

#include "core/geometry/grid.h"
#include "core/recognition/curve.h"
#include "core/replacing/draws.h"

namespace tessera::bench {

/// How what is seen becomes a query, in this order.
struct View {
  double turned_rad = 0;  // about the middle of what is seen
  double size = 1;        // px of the query for one px of the mask
  int jpeg_quality = 0;   // 1 to 100: the drawn mask is kept as a JPEG; 0: it is not
  double noise_px = 0;    // standard deviation across the boundary, at points 1 px apart, query px
};

/// The distance of a point from what hides a part of the mask, mask px.
using HiderDistance = std::function<double(Vec2 mask_point)>;

/// The boundary of what is seen (CV_8U: 255 inside, else 0), query px, interior on the left. No curve where nothing is
/// seen that is larger than a few pixels. Points at the hider are cut out of the curves, which are open then; an empty
/// `from_hider`: all counts as boundary. `draws` gives the noise. Throws InputError where the drawn mask is too large for
/// a JPEG.
std::vector<Curve> seen_curves(const cv::Mat& seen, const View& view, const HiderDistance& from_hider, Draws& draws);

/// The values of a mask as the tracing of outlines takes them, 0 to 1.
Grid<float> coverage_of(const cv::Mat& mask);

}  // namespace tessera::bench
