#include "products/elements/touching_elements.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace tessera {
namespace {

/// Of what is within a region as thick as where it is thickest: its neck, where it touches another one, is thinner, and
/// what is no thicker beside it is no element. The tab of a jigsaw's piece is a third as thick as the piece, whose waist
/// is two thirds.
constexpr double kNeck = 0.35, kLeastElement = 0.6;

bool is_several(const cv::Mat& region) {
  cv::Mat mask, thickness;
  cv::copyMakeBorder(region, mask, 1, 1, 1, 1, cv::BORDER_CONSTANT);
  cv::distanceTransform(mask, thickness, cv::DIST_L2, 5);
  double most = 0;
  cv::minMaxLoc(thickness, nullptr, &most);
  cv::Mat parts;
  const int count = cv::connectedComponents(thickness > kNeck * most, parts, 8);
  int elements = 0;
  for (int part = 1; part < count; ++part) {
    double in_part = 0;
    cv::minMaxLoc(thickness, nullptr, &in_part, nullptr, nullptr, parts == part);
    if (in_part > kLeastElement * most) ++elements;
  }
  return elements > 1;
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
    std::vector<double> shared_px2(touch.size(), 0);
    for (const LabelRun& run : searched.runs_of(label)) {
      for (int x = run.x; x < run.x + run.length; ++x) ++shared_px2[std::size_t(whole.at<int>(run.y, x))];
    }
    const std::size_t in = std::size_t(std::max_element(shared_px2.begin(), shared_px2.end()) - shared_px2.begin());
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
