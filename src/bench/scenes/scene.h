// Scenes in which a part of a silhouette is hidden, with the truth known (paper, Fig. 4a). All masks are CV_8U: 255 inside,
// else 0.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "bench/blocking/seen_curves.h"
#include "core/replacing/draws.h"

namespace tessera::bench {

/// Both masks have the same size and frame, px of the lower silhouette's mask.
struct Scene {
  cv::Mat lower;  // the silhouette, whole
  cv::Mat hider;  // what lies over it

  /// The part of the silhouette that shows, and both as one silhouette.
  cv::Mat seen() const;
  cv::Mat united() const;
  /// The hidden part of the silhouette's area, 0 to 1.
  double hidden() const;
};

/// This part of the width is hidden, from the left: the paper's Figs. 26 and 27.
Scene clipped_scene(const cv::Mat& lower, double hidden);

/// Another silhouette lies over the lower one and hides this part of its area, to a pixel's share: turned at random, taken so
/// many times as large as the lower one (areas), and moved away in a random direction until it hides no more. Empty where
/// it cannot hide that much.
std::optional<Scene> covered_scene(const cv::Mat& lower, const cv::Mat& upper, double hidden, double times_as_large,
                                   Draws& draws);

/// Two to six parallel bars, as a fence's: their width is what hides this part of the area.
Scene bars_scene(const cv::Mat& lower, double hidden, Draws& draws);

/// A branch with twigs that bear twigs of their own, grown across the silhouette: as thick as hides this part of the area.
Scene branch_scene(const cv::Mat& lower, double hidden, Draws& draws);

/// Distances from the scene's hider. The scene need not outlive it.
HiderDistance distance_from_hider(const Scene& scene);

}  // namespace tessera::bench
