#include "artwork/alpha_regions.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "artwork/images/page_pixels.h"

namespace tessera {
namespace {

/// A pixel lies on an edge where the range of alpha (largest minus smallest value) within 1 px is at least this part of
/// the range within `kNearEdge_px`. A blur with a standard deviation of 1.3 px or more gives a smaller part.
constexpr double kEdgePart = 0.6;
constexpr int kNearEdge_px = 3;
/// An area that is no wider than this is a line.
constexpr int kLine_px = 4;
/// A pixel counts as flat where its alpha differs from its region's mean by at most this part of the mean.
constexpr double kFlat = 0.3;

/// The largest minus the smallest alpha within `radius_px` of each pixel, CV_8U.
cv::Mat range_within(const cv::Mat& alpha, int radius_px) {
  cv::Mat most, least;
  cv::dilate(alpha, most, square(radius_px));
  cv::erode(alpha, least, square(radius_px));
  return most - least;
}

/// CV_8U, 255 on edges, where alpha jumps.
cv::Mat edges_of(const cv::Mat& alpha, int unit_px, double least_step) {
  const cv::Mat step = range_within(alpha, unit_px), way = range_within(alpha, kNearEdge_px * unit_px);
  return (step >= least_step) & (step >= way * kEdgePart);
}

/// Removes all areas that are no wider than a line. Veins and outlines of a wing do not tell how opaque it is, nor do
/// gaps between lines.
cv::Mat without_lines(const cv::Mat& alpha, int unit_px) {
  cv::Mat wide;
  cv::morphologyEx(alpha, wide, cv::MORPH_OPEN, square(kLine_px / 2 * unit_px), {-1, -1}, 1, cv::BORDER_CONSTANT,
                   cv::Scalar(0));
  return wide;
}

/// CV_8U, 255 where clear pixels are connected to the page's edge: holes in the drawing are not.
cv::Mat outside_of(const cv::Mat& alpha, int clear_alpha) { return connected_to_edge(alpha < clear_alpha); }

class Measurement {
 public:
  Measurement(const cv::Mat& alpha, int unit_px, const RegionRules& rules)
      : alpha_(alpha),
        rules_(rules),
        wide_(rules.has_lines ? alpha : without_lines(alpha, unit_px)),
        outside_(outside_of(alpha, rules.clear_alpha)),
        reach_px_(kEdgeWidth_px * unit_px) {
    const cv::Mat smooth = ~edges_of(wide_, unit_px, rules.least_step) & (wide_ >= rules_.clear_alpha) &
                           (alpha >= rules_.clear_alpha) & (alpha < kOpaqueAlpha);
    found_.regions.resize(std::size_t(cv::connectedComponents(smooth, found_.label, rules.has_lines ? 8 : 4, CV_32S)));
    core_ = without_lines(smooth, unit_px);
  }

  AlphaRegions measured() {
    if (found_.regions.size() == 1) return std::move(found_);
    for_pixels([this](AlphaRegion& region, cv::Point at) { measure(region, at); });
    for (AlphaRegion& region : found_.regions) region.level /= std::max(1, region.pixels);
    for_pixels([this](AlphaRegion& region, cv::Point at) {
      const bool is_flat = std::abs(wide_.at<std::uint8_t>(at) - region.level) <= kFlat * region.level;
      if (is_flat) region.flat_part += 1. / region.pixels;
    });
    return std::move(found_);
  }

 private:
  template <class Do>
  void for_pixels(Do act) {
    for (int y = 0; y < alpha_.rows; ++y) {
      for (int x = 0; x < alpha_.cols; ++x) {
        const int label = label_at({x, y});
        if (label > 0) act(found_.regions[std::size_t(label)], cv::Point(x, y));
      }
    }
  }

  void measure(AlphaRegion& region, cv::Point at) const {
    const int alpha = wide_.at<std::uint8_t>(at);
    ++region.pixels;
    region.core_pixels += core_.at<std::uint8_t>(at) > 0;
    region.level += alpha;
    region.most = std::max(region.most, alpha);
    region.least = std::min(region.least, alpha);
    for (const cv::Point step : {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
      look_beyond(region, at, step);
    }
  }

  /// Counts what lies next to a pixel of the region in one direction, behind an edge if there is one. The end of the
  /// page and edges of holes do not count.
  void look_beyond(AlphaRegion& region, cv::Point from, cv::Point step) const {
    const cv::Rect page({0, 0}, alpha_.size());
    for (int i = 1; i <= reach_px_; ++i) {
      const cv::Point at = from + step * i;
      if (!page.contains(at) || label_at(at) == label_at(from)) return;
      if (i < reach_px_ && in_edge(at)) continue;
      if (alpha_.at<std::uint8_t>(at) < rules_.clear_alpha && !outside_.at<std::uint8_t>(at)) {
        if (i == 1) ++region.fading_in_holes;
        return;
      }
      const int fall = alpha_.at<std::uint8_t>(from) - alpha_.at<std::uint8_t>(at);
      if (i == 1) ++(fall > 0 ? region.fading : region.merging);
      if (i > 1) ++(fall > 0 ? falling_border(region, from, at, step) : region.rising);
      return;
    }
  }

  /// The counter for a fall of alpha. `at`: the first pixel behind the edge; a clear one may still belong to the edge.
  int& falling_border(AlphaRegion& region, cv::Point from, cv::Point at, cv::Point step) const {
    const cv::Point next = cv::Rect({0, 0}, alpha_.size()).contains(at + step) ? at + step : at;
    const int behind = std::min(alpha_.at<std::uint8_t>(at), alpha_.at<std::uint8_t>(next));
    const bool is_slight = alpha_.at<std::uint8_t>(from) - behind < rules_.least_fall;
    return is_slight ? region.slightly_falling : region.falling;
  }

  int label_at(cv::Point at) const { return found_.label.at<int>(at); }

  bool in_edge(cv::Point at) const {
    const int alpha = alpha_.at<std::uint8_t>(at);
    return label_at(at) == 0 && alpha >= rules_.clear_alpha && alpha < kOpaqueAlpha;
  }

  const cv::Mat& alpha_;
  const RegionRules& rules_;
  const cv::Mat wide_;
  const cv::Mat outside_;
  cv::Mat core_;  // CV_8U, 255 where a region is wider than a line
  const int reach_px_;
  AlphaRegions found_;
};

}  // namespace

AlphaRegions alpha_regions(const cv::Mat& alpha, int unit_px, const RegionRules& rules) {
  return Measurement(alpha, unit_px, rules).measured();
}

}  // namespace tessera
