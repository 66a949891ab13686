#include "products/elements/touching_elements.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <opencv2/imgproc.hpp>

namespace tessera {
namespace {

/// Parts of a region's largest thickness. Where two elements touch, the region is thinner than kNeck. A part beyond such a
/// neck is an element if it is thicker than kLeastElement. The tab of a jigsaw piece is a third as thick as the piece, so
/// it is none.
constexpr double kNeck = 0.35, kLeastElement = 0.6;

bool is_several(const cv::Mat& region) {
  cv::Mat mask, thickness;
  cv::copyMakeBorder(region, mask, 1, 1, 1, 1, cv::BORDER_CONSTANT);
  cv::distanceTransform(mask, thickness, cv::DIST_L2, 5);
  double most = 0;
  cv::minMaxLoc(thickness, nullptr, &most);
  cv::Mat parts;
  const int count = cv::connectedComponents(thickness > kNeck * most, parts, 8);
  std::vector<char> is_element(std::size_t(count), 0);
  for (int y = 0; y < parts.rows; ++y) {
    for (int x = 0; x < parts.cols; ++x) {
      if (thickness.at<float>(y, x) > kLeastElement * most) is_element[std::size_t(parts.at<int>(y, x))] = 1;
    }
  }
  return std::count(is_element.begin(), is_element.end(), 1) > 1;
}

}  // namespace

std::vector<bool> touching_regions(const LabelRuns& labels) {
  std::vector<bool> touch(labels.regions().size(), false);
  for (std::size_t label = 1; label < touch.size(); ++label) {
    if (labels.regions()[label].area_px2 > 0) touch[label] = is_several(labels.mask_of(label));
  }
  return touch;
}

LabelRuns with_touching_apart(const LabelRuns& apart, const std::vector<bool>& touch, const LabelRuns& searched) {
  const cv::Mat whole = apart.labels();
  std::vector<std::vector<LabelRun>> runs(1);
  std::vector<bool> is_replaced(touch.size(), false);
  for (std::size_t label = 1; label < searched.regions().size(); ++label) {
    std::map<int, int> shared_px2;  // with the ground and with each region
    for (const LabelRun& run : searched.runs_of(label)) {
      for (int x = run.x; x < run.x + run.length; ++x) ++shared_px2[whole.at<int>(run.y, x)];
    }
    const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
    if (shared_px2.empty()) continue;
    const auto in = std::size_t(std::max_element(shared_px2.begin(), shared_px2.end(), less)->first);
    if (!touch[in]) continue;
    is_replaced[in] = true;
    const auto found = searched.runs_of(label);
    runs.emplace_back(found.begin(), found.end());
  }
  for (std::size_t label = 1; label < touch.size(); ++label) {
    if (is_replaced[label]) continue;
    const auto found = apart.runs_of(label);
    runs.emplace_back(found.begin(), found.end());
  }
  return {apart.size(), runs};
}

}  // namespace tessera
