#include "products/elements/segmentation/label_runs.h"

#include <algorithm>

namespace tessera {
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

std::size_t run_count(const cv::Mat& labels) {
  std::size_t count = 0;
  each_run(labels, [&](std::size_t, const LabelRun&) { ++count; });
  return count;
}

void append_runs(const cv::Mat& mask, cv::Point corner, std::vector<LabelRun>& runs) {
  for (int y = 0; y < mask.rows; ++y) {
    const std::uint8_t* row = mask.ptr<std::uint8_t>(y);
    for (int x = 0; x < mask.cols;) {
      int end = x + 1;
      while (end < mask.cols && (row[end] != 0) == (row[x] != 0)) ++end;
      if (row[x]) runs.push_back({corner.x + x, corner.y + y, end - x});
      x = end;
    }
  }
}

LabelRuns::LabelRuns(const cv::Mat& labels) : size_(labels.size()), regions_(region_boxes(labels)) {
  first_.assign(regions_.size() + 1, 0);
  each_run(labels, [&](std::size_t label, const LabelRun&) { ++first_[label + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  runs_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  each_run(labels, [&](std::size_t label, const LabelRun& run) { runs_[next[label]++] = run; });
}

LabelRuns::LabelRuns(cv::Size size, const std::vector<std::vector<LabelRun>>& runs)
    : size_(size),
      regions_(std::max<std::size_t>(1, runs.size())),
      first_(regions_.size() + 1) {
  for (std::size_t label = 1; label < runs.size(); ++label) {
    for (const LabelRun& run : runs[label]) {
      const cv::Rect pixels(run.x, run.y, run.length, 1);
      RegionBox& region = regions_[label];
      region.box = region.area_px2 == 0 ? pixels : region.box | pixels;
      region.area_px2 += run.length;
    }
    runs_.insert(runs_.end(), runs[label].begin(), runs[label].end());
    first_[label + 1] = runs_.size();
  }
}

std::span<const LabelRun> LabelRuns::runs_of(std::size_t label) const {
  return std::span(runs_).subspan(first_[label], first_[label + 1] - first_[label]);
}

cv::Mat LabelRuns::mask_of(std::size_t label, const cv::Rect& window) const {
  cv::Mat mask = cv::Mat::zeros(window.size(), CV_8U);
  for (const LabelRun& run : runs_of(label)) {
    if (run.y < window.y || run.y >= window.br().y) continue;
    const int from = std::max(run.x, window.x), to = std::min(run.x + run.length, window.br().x);
    std::uint8_t* row = mask.ptr<std::uint8_t>(run.y - window.y) - window.x;
    if (from < to) std::fill(row + from, row + to, std::uint8_t(255));
  }
  return mask;
}

cv::Mat LabelRuns::mask() const {
  cv::Mat mask = cv::Mat::zeros(size_, CV_8U);
  for (const LabelRun& run : runs_) {
    std::uint8_t* from = mask.ptr<std::uint8_t>(run.y) + run.x;
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

}  // namespace tessera
