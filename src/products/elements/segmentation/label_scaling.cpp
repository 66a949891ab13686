#include "products/elements/segmentation/label_scaling.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "products/elements/segmentation/region_labels.h"

namespace tessera {
namespace {

/// Smooths the steps of the copy's pixels; in px of the copy.
constexpr double kSmooth_px = 0.8;
constexpr int kMargin_px = 3;
/// Pixels that are scaled at a time, because a region may be as large as the photo.
constexpr int kMostScaled_px2 = 4'000'000;

/// A region at its new size.
struct Scaled {
  std::vector<LabelRun> runs;
  int area_px2 = 0;
};

/// Joins regions that lie in a hole of a larger one to that one.
LabelRuns without_hidden(const std::vector<Scaled>& regions, cv::Mat taken) {
  std::vector<std::size_t> order(regions.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return regions[a].area_px2 < regions[b].area_px2; });
  taken.setTo(0);
  std::vector<std::vector<LabelRun>> seen(regions.size());
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    for (const LabelRun& run : regions[*i].runs) {
      cv::Mat there = taken(cv::Rect(run.x, run.y, run.length, 1));
      append_runs(there == 0, {run.x, run.y}, seen[*i]);
      there.setTo(255);
    }
  }
  std::vector<std::vector<LabelRun>> numbered(1);
  for (std::vector<LabelRun>& runs : seen) {
    if (!runs.empty()) numbered.push_back(std::move(runs));
  }
  return {taken.size(), numbered};
}

}  // namespace

LabelRuns scaled_labels(const cv::Mat& labels, cv::Size size) {
  const double scale_x = double(size.width) / labels.cols;
  const double scale_y = double(size.height) / labels.rows;
  cv::Mat taken = cv::Mat::zeros(size, CV_8U);
  std::vector<Scaled> scaled;
  const std::vector<RegionBox> regions = region_boxes(labels);
  for (std::size_t i = 1; i < regions.size(); ++i) {
    // The border repeats the copy's edge, so that a region cut by the edge stays cut there.
    const cv::Rect box = regions[i].box;
    const cv::Rect part = grown_within(box, kMargin_px, labels.size());
    cv::Mat soft;
    cv::Mat(labels(part) == int(i)).convertTo(soft, CV_32F, 1 / 255.);
    cv::GaussianBlur(soft, soft, {}, kSmooth_px, kSmooth_px, cv::BORDER_REPLICATE);
    const cv::Rect target =
        cv::Rect(cv::Point(int(std::floor(part.x * scale_x)), int(std::floor(part.y * scale_y))),
                 cv::Point(int(std::ceil(part.br().x * scale_x)), int(std::ceil(part.br().y * scale_y)))) &
        cv::Rect({0, 0}, size);
    cv::Mat there = taken(target), free(target.size(), CV_8U);
    const int rows_at_a_time = std::max(1, kMostScaled_px2 / std::max(1, target.width));
    for (int y = 0; y < target.height; y += rows_at_a_time) {
      const cv::Range rows(y, std::min(y + rows_at_a_time, target.height));
      // Pixel centres: (x + 0.5) / scale - 0.5 in the copy for x in the photo.
      const cv::Matx23d to_copy(1 / scale_x, 0, (target.x + 0.5) / scale_x - 0.5 - part.x, 0, 1 / scale_y,
                                (target.y + y + 0.5) / scale_y - 0.5 - part.y);
      cv::Mat fine;
      cv::warpAffine(soft, fine, to_copy, {target.width, rows.size()}, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                     cv::BORDER_REPLICATE);
      free.rowRange(rows) = (fine >= 0.5F) & (there.rowRange(rows) == 0);
    }
    there.setTo(255, free);
    const cv::Mat solid = solid_part(free);
    scaled.push_back({{}, cv::countNonZero(solid)});
    append_runs(solid, target.tl(), scaled.back().runs);
  }
  return without_hidden(scaled, taken);
}

}  // namespace tessera
