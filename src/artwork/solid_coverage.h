// Decides which parts of a drawing belong to its silhouette: translucent parts do, soft shadows do not.
//
// Alpha alone does not tell a wing of opacity 0.4 from a shadow. But the wing ends at an edge, with constant opacity
// beside it; a shadow fades out over many pixels. So the drawing is divided into smooth regions, between which alpha
// jumps, and each region is judged by its outer border.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

struct SolidCoverage {
  /// The part of each pixel that the drawing's body covers, CV_8U, used like alpha: the outline runs at one half.
  /// - Parts with an opacity of 0.08 or more that end at an edge are covered fully, if they touch an opaque part or
  /// there is no opaque part.
  /// - Parts that fade out beside a body with an edge are shadows or halos, and not covered.
  /// - Everything else is covered as far as it is opaque, blurred bodies included.
  /// If none of these rules changes a pixel, the coverage is `alpha` itself, to the byte.
  cv::Mat coverage;
  int loose_parts = 0;       // translucent parts that touch no opaque part, and are therefore not covered
  bool loses_parts = false;  // some parts with an edge are too faint, or lines too thin, to be covered
};

/// Computes the coverage. `alpha`: CV_8U. `source_px`: size of a pixel of the source in px of `alpha`, above 1 for an
/// enlarged image, whose edges are wider.
SolidCoverage solid_coverage(const cv::Mat& alpha, double source_px);

}  // namespace tessera
