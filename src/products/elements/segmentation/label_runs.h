// A label map in little room: where each label's pixels run along the rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "products/elements/segmentation/region_labels.h"

namespace tessera {

struct LabelRun {
  std::int32_t x = 0, y = 0;
  std::int32_t length = 0;  // px
};

/// How many runs a label map has, which take 12 bytes each.
std::size_t run_count(const cv::Mat& labels);

/// Adds the runs of a mask (CV_8U) whose upper left corner lies at `corner`.
void append_runs(const cv::Mat& mask, cv::Point corner, std::vector<LabelRun>& runs);

/// Some per cent of the map's size where regions are as wide as elements.
class LabelRuns {
 public:
  /// Of a label map (region_labels.h).
  explicit LabelRuns(const cv::Mat& labels);
  /// Of each label, [0] is unused, from top to bottom and from left to right.
  LabelRuns(cv::Size size, const std::vector<std::vector<LabelRun>>& runs);

  cv::Size size() const { return size_; }
  /// Where each label lies and how large it is; [0] is unused.
  const std::vector<RegionBox>& regions() const { return regions_; }
  /// From top to bottom and from left to right.
  std::span<const LabelRun> runs_of(std::size_t label) const;
  /// What of the window has the label: CV_8U, 0 or 255.
  cv::Mat mask_of(std::size_t label, const cv::Rect& window) const;
  /// Of its box.
  cv::Mat mask_of(std::size_t label) const { return mask_of(label, regions_[label].box); }
  /// What has any label: CV_8U, 0 or 255.
  cv::Mat mask() const;
  /// The map again, CV_32S.
  cv::Mat labels() const;

 private:
  cv::Size size_;
  std::vector<RegionBox> regions_;
  std::vector<std::size_t> first_;  // of each label in runs_, and the end
  std::vector<LabelRun> runs_;
};

}  // namespace tessera
