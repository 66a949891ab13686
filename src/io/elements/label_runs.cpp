#include "io/elements/label_runs.h"

#include <algorithm>

namespace tessera::io {
namespace {

/// Calls f(label, run) for each run of labels above 0, row by row.
template <class F>
void each_run(const cv::Mat& labels, F f) {
  for (int y = 0; y < labels.rows; ++y) {
    const int* row = labels.ptr<int>(y);
    for (int x = 0; x < labels.cols;) {
      int end = x + 1;
      while (end < labels.cols && row[end] == row[x]) ++end;
      if (row[x] > 0) f(std::size_t(row[x]), LabelRun{x, y, end - x});
      x = end;
    }
  }
}

}  // namespace

LabelRuns::LabelRuns(const cv::Mat& labels) : size_(labels.size()), regions_(region_boxes(labels)) {
  first_.assign(regions_.size() + 1, 0);
  each_run(labels, [&](std::size_t label, const LabelRun&) { ++first_[label + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  runs_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  each_run(labels, [&](std::size_t label, const LabelRun& run) { runs_[next[label]++] = run; });
}

std::span<const LabelRun> LabelRuns::runs_of(std::size_t label) const {
  return std::span(runs_).subspan(first_[label], first_[label + 1] - first_[label]);
}

cv::Mat LabelRuns::mask_of(std::size_t label) const {
  const cv::Rect& box = regions_[label].box;
  cv::Mat mask = cv::Mat::zeros(box.size(), CV_8U);
  for (const LabelRun& run : runs_of(label)) {
    std::uint8_t* from = mask.ptr<std::uint8_t>(run.y - box.y) + (run.x - box.x);
    std::fill(from, from + run.length, std::uint8_t(255));
  }
  return mask;
}

cv::Mat LabelRuns::labels() const {
  cv::Mat labels = cv::Mat::zeros(size_, CV_32S);
  for (std::size_t label = 1; label < regions_.size(); ++label) {
    for (const LabelRun& run : runs_of(label)) {
      int* from = labels.ptr<int>(run.y) + run.x;
      std::fill(from, from + run.length, int(label));
    }
  }
  return labels;
}

}  // namespace tessera::io
