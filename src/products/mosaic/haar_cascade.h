// A cascade of Haar-like features (Viola and Jones 2001). A window slides over the picture at all sizes. It is refused
// early where it does not show what the cascade was trained for. It accepts the same windows as OpenCV's detector, apart
// from rounding at a threshold. OpenCV's detector is in a library whose development package needs a hundred others.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// A rectangle of the window, whose sum of greys is multiplied by `weight`.
struct HaarPart {
  cv::Rect box_px;
  double weight = 0;
};
using HaarFeature = std::vector<HaarPart>;

/// Compares a feature, divided by the contrast of the window, with a threshold. `below`, `from`: what follows in each case.
/// A positive number is a later node of the tree; any other number is minus the number of a leaf.
struct HaarNode {
  int below = 0, from = 0;
  int feature = 0;
  double threshold = 0;
};

struct HaarTree {
  std::vector<HaarNode> nodes;
  std::vector<double> leaves;
};

/// Accepts a window where the leaves of its trees have at least this sum.
struct HaarStage {
  std::vector<HaarTree> trees;
  double threshold = 0;
};

struct HaarHit {
  cv::Rect box_px;
  int windows = 0;  // number of windows accepted here: the more, the surer
};

class HaarCascade {
 public:
  /// Throws InputError where an index or a rectangle is out of range.
  HaarCascade(cv::Size window_px, std::vector<HaarFeature> features, std::vector<HaarStage> stages);

  /// Slides windows with sides from `smallest_px` to `largest_px` over `grey` (CV_8U), and joins accepted windows at the
  /// same place. Returns the places with at least `fewest` windows, the surest first. The result is the same on any number
  /// of threads.
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
