// A cascade of Haar-like features (Viola and Jones 2001): a window slides over the picture at all sizes, and is refused
// early where it does not hold what the cascade was trained for. The windows that it accepts are those of OpenCV's
// detector, but for rounding at a threshold. OpenCV's own lies in a library whose development package needs a hundred
// others.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// A rectangle of the window, whose sum of greys counts `weight` times.
struct HaarPart {
  cv::Rect box_px;
  double weight = 0;
};
using HaarFeature = std::vector<HaarPart>;

/// Asks whether a feature, divided by the contrast of the window, is below a threshold. `below`, `from`: what comes
/// then. A positive number is that of a later node of the tree; any other is minus the number of a leaf.
struct HaarNode {
  int below = 0, from = 0;
  int feature = 0;
  double threshold = 0;
};

struct HaarTree {
  std::vector<HaarNode> nodes;
  std::vector<double> leaves;
};

/// Accepts a window where the leaves of its trees have this sum at least.
struct HaarStage {
  std::vector<HaarTree> trees;
  double threshold = 0;
};

struct HaarHit {
  cv::Rect box_px;
  int windows = 0;  // that were accepted here: the more, the surer
};

class HaarCascade {
 public:
  /// Throws InputError where an index or a rectangle leads elsewhere.
  HaarCascade(cv::Size window_px, std::vector<HaarFeature> features, std::vector<HaarStage> stages);

  /// Slides windows with sides from `smallest_px` to `largest_px` over `grey` (CV_8U) and joins those accepted that
  /// lie at one place. Returns the places with `fewest` windows or more, the surest first: the same each time, whatever
  /// the threads.
  std::vector<HaarHit> find(const cv::Mat& grey, int smallest_px, int largest_px, int fewest) const;

 private:
  class Layer;

  void check_tree(const HaarTree& tree) const;
  void scan(const Layer& layer, double scale, std::vector<cv::Rect>& accepted) const;
  bool accepts(const Layer& layer, cv::Point at) const;

  cv::Size window_px_;
  std::vector<HaarFeature> features_;
  std::vector<HaarStage> stages_;
};

}  // namespace tessera
