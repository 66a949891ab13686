// A label map in little memory: the runs of each label's pixels along the rows.
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

/// The number of runs of a label map; each takes 12 bytes.
std::size_t run_count(const cv::Mat& labels);

/// Adds the runs of a mask (CV_8U) whose upper left corner is at `corner`.
void append_runs(const cv::Mat& mask, cv::Point corner, std::vector<LabelRun>& runs);

/// The runs take some per cent of the map's size where regions are as wide as elements.
class LabelRuns {
 public:
  /// The runs of a label map (region_labels.h).
  explicit LabelRuns(const cv::Mat& labels);
  /// The runs of each label, from top to bottom and from left to right; [0] is unused.
  LabelRuns(cv::Size size, const std::vector<std::vector<LabelRun>>& runs);

  cv::Size size() const { return size_; }
  /// Place and size of each label; [0] is unused.
  const std::vector<RegionBox>& regions() const { return regions_; }
  /// The runs of a label, from top to bottom and from left to right.
  std::span<const LabelRun> runs_of(std::size_t label) const;
  /// The pixels of the label within the window: CV_8U, 0 or 255.
  cv::Mat mask_of(std::size_t label, const cv::Rect& window) const;
  /// The pixels of the label within its bounding box.
  cv::Mat mask_of(std::size_t label) const { return mask_of(label, regions_[label].box); }
  /// The pixels with any label: CV_8U, 0 or 255.
  cv::Mat mask() const;
  /// The label map, CV_32S.
  cv::Mat labels() const;

 private:
  cv::Size size_;
  std::vector<RegionBox> regions_;
  std::vector<std::size_t> first_;  // of each label: its first run in runs_; at the end, the number of runs
  std::vector<LabelRun> runs_;
};

}  // namespace tessera
