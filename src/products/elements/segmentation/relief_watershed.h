// Watersheds of a relief, and merging of shallow basins. (cv::watershed floods by differences of colour instead.)
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// `relief`: CV_32F. `mask`: CV_8U, the pixels that may be flooded; empty: all. Each minimum of the relief floods its own
/// basin. Returns labels, CV_32S: 1..n = basins, each connected by sides of pixels, 0 = outside the mask.
cv::Mat basins_of(const cv::Mat& relief, const cv::Mat& mask = {});

/// Whether two neighbouring basins are one. `saddle`: the lowest pass between them. `floor`: the lowest point of the
/// shallower basin.
using OneBasin = std::function<bool(float saddle, float floor)>;

/// Merges neighbouring basins of a relief. It looks for their saddles once, however many ways to merge are tried.
class BasinMerger {
 public:
  struct Saddle {
    float level;
    int a, b;  // a < b
  };

  /// `basins`: from basins_of() with this relief; the merger keeps the labels.
  BasinMerger(const cv::Mat& relief, const cv::Mat& basins);

  /// Merges where `one_basin` says so, beginning at the lowest saddle. Labels 1..n without gaps.
  cv::Mat merged(const OneBasin& one_basin) const;

 private:
  cv::Mat basins_;
  std::vector<float> floors_;    // by basin; [0] is unused
  std::vector<Saddle> saddles_;  // the lowest one of each two neighbours, the lowest first
};

}  // namespace tessera
