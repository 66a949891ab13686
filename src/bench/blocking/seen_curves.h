// Makes queries from masks: the visible part of a silhouette is drawn anew in pixels and traced, and edges of the hider
// are cut out.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <vector>

#include "core/geometry/grid.h"
#include "core/recognition/curve.h"
#include "core/replacing/draws.h"

namespace tessera::bench {

/// The steps from the visible part to a query, in this order.
struct View {
  double turned_rad = 0;  // about the centre of the visible part
  double size = 1;        // query px for one px of the mask
  int jpeg_quality = 0;   // 1 to 100: the drawn mask is stored as a JPEG; 0: it is not
  double noise_px = 0;    // query px, standard deviation across the boundary, at points 1 px apart
};

/// Returns the distance of a point from the hider of a part of the mask, in mask px.
using HiderDistance = std::function<double(Vec2 mask_point)>;

/// The boundary of the visible part `seen` (CV_8U: 255 inside, else 0), query px, interior on the left. Empty where the
/// visible part has only a few pixels. Points at the hider are cut out of the curves, which are open then; with an
/// empty `from_hider` everything counts as boundary. `draws` gives the noise. Throws InputError where the drawn mask is
/// too large for a JPEG.
std::vector<Curve> seen_curves(const cv::Mat& seen, const View& view, const HiderDistance& from_hider, Draws& draws);

/// The values of a mask as 0 to 1, for the tracing of outlines.
Grid<float> coverage_of(const cv::Mat& mask);

}  // namespace tessera::bench
