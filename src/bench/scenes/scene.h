// Scenes in which a known part of a silhouette is hidden (paper, Fig. 4a). All masks are CV_8U: 255 inside, else 0.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "bench/blocking/seen_curves.h"
#include "core/replacing/draws.h"

namespace tessera::bench {

/// A scene. Both masks have the same size and frame: px of the lower silhouette's mask.
struct Scene {
  cv::Mat lower;  // the whole silhouette
  cv::Mat hider;  // the object over it

  /// The visible part of the silhouette; united() has both as one silhouette.
  cv::Mat seen() const;
  cv::Mat united() const;
  /// The hidden part of the silhouette's area, 0 to 1.
  double hidden() const;
};

/// Hides this part of the width, from the left, as in the paper's Figs. 26 and 27.
Scene clipped_scene(const cv::Mat& lower, double hidden);

/// Lays another silhouette over the lower one so that it hides this part of the area, to a fraction of a pixel. The
/// upper one has a random rotation and `times_as_large` times the lower one's area, and is moved away in a random
/// direction until it hides no more. Nullopt where it cannot hide that much.
std::optional<Scene> covered_scene(const cv::Mat& lower, const cv::Mat& upper, double hidden, double times_as_large,
                                   Draws& draws);

/// Hides this part of the area with two to six parallel bars, like a fence; their width is fitted.
Scene bars_scene(const cv::Mat& lower, double hidden, Draws& draws);

/// Hides this part of the area with a branch across the silhouette, whose twigs have twigs; the thickness is fitted.
Scene branch_scene(const cv::Mat& lower, double hidden, Draws& draws);

/// The distance function of the scene's hider. The scene need not outlive it.
HiderDistance distance_from_hider(const Scene& scene);

}  // namespace tessera::bench
