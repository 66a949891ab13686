// What of a drawing counts as its silhouette: translucent parts do, soft shadows do not.
//
// Alpha alone does not tell a wing of opacity 0.4 from a shadow. But the wing ends at an edge, and its opacity goes on
// beside the edge; a shadow fades out over many pixels. So the drawing is cut into smooth regions, between which alpha
// jumps, and each region is judged by how it ends on its outer side.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

struct SolidCoverage {
  /// How much of each pixel the drawing's body covers, CV_8U, to be read as alpha: the outline runs at one half.
  /// - Parts of any opacity of 0.08 and more that end at an edge are covered wholly, if they touch an opaque part or
  ///   there is none.
  /// - What fades out to nothing beside a body with an edge is a shadow or a halo, and not covered.
  /// - Everything else is covered as far as it is opaque, among it bodies that are blurred themselves.
  /// Where no part of the drawing is concerned, this is `alpha` itself, to the byte.
  cv::Mat coverage;
  int loose_parts = 0;       // translucent ones that touch no opaque part, and are not covered therefore
  bool loses_parts = false;  // parts with an edge are too faint, or lines too thin, to be covered
};

/// `alpha`: CV_8U. `source_px`: size of a pixel of the source in pixels of `alpha`, above 1 for an enlarged image, whose
/// edges are wider.
SolidCoverage solid_coverage(const cv::Mat& alpha, double source_px);

}  // namespace tessera
