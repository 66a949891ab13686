#include "products/elements/element_size.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "products/elements/candidate_maps.h"
#include "products/elements/segmentation/boundary_map.h"
#include "products/elements/segmentation/label_runs.h"
#include "products/elements/segmentation/region_labels.h"
#include "products/elements/segmentation/region_vote.h"

namespace tessera {
namespace {

/// Sizes that are tried, px of the photo: from the smallest by this factor.
constexpr double kLeastTried_px = 10;
constexpr double kFactor = 1.6;
/// A photo shows no texture of elements that are larger than this part of its shorter side.
constexpr double kLargestPart = 0.4;
/// Small elements are looked for in the middle of the photo only: so many px of the enlarged copy.
constexpr double kMostTried_px2 = 500e3;
/// Least part of the copy that regions must support: less is noise.
constexpr double kLeastSupport = 0.08;

/// The middle of the photo in which elements of this size are 40 px wide.
cv::Mat copy_for(const cv::Mat& photo, double zoom) {
  const double part = std::min(1., std::sqrt(kMostTried_px2 / (zoom * zoom * double(photo.total()))));
  const cv::Size size(int(photo.cols * part), int(photo.rows * part));
  const cv::Rect middle({(photo.cols - size.width) / 2, (photo.rows - size.height) / 2}, size);
  cv::Mat copy;
  cv::resize(photo(middle), copy, {}, zoom, zoom, zoom < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
  return bgr_of(copy);
}

/// The middle short side of the regions, where large ones count more; 0: there is none.
double usual_side_px(const LabelRuns& regions) {
  std::vector<std::pair<double, double>> sides;  // with the area
  double all_px2 = 0;
  for (std::size_t i = 1; i < regions.regions().size(); ++i) {
    const double area_px2 = regions.regions()[i].area_px2;
    if (area_px2 == 0) continue;
    std::vector<cv::Point> pixels;
    cv::findNonZero(regions.mask_of(i), pixels);
    const cv::Size2f box = cv::minAreaRect(pixels).size;
    sides.emplace_back(std::min(box.width, box.height) + 1, area_px2);
    all_px2 += area_px2;
  }
  std::sort(sides.begin(), sides.end());
  double below_px2 = 0;
  for (const auto& [side, area_px2] : sides) {
    if ((below_px2 += area_px2) >= all_px2 / 2) return side;
  }
  return 0;
}

struct Trial {
  double support = 0;  // the part of the photo's middle that regions of the tried size support
  double side_px = 0;  // of these regions, px of the photo
};

Trial tried(const cv::Mat& photo, double element_px) {
  const double zoom = kElement_px / element_px;
  const cv::Mat copy = copy_for(photo, zoom);
  const cv::Mat lab = smooth_lab(copy);
  const std::vector<LabelRuns> maps = candidate_maps(copy, lab, lab.size());
  const VotedRegions voted = voted_regions(maps, boundary_map(lab, {}), kElement_px);
  return {.support = voted.support_px2 / double(copy.total()),
          .side_px = usual_side_px(LabelRuns(voted.labels)) / zoom};
}

/// The place where a parabola through three values, one step from each other, is greatest: -0.5 to 0.5 steps from the middle
/// one.
double peak(double before, double middle, double after) {
  const double bend = before - 2 * middle + after;
  return bend < 0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0;
}

}  // namespace

double found_element_px(const cv::Mat& photo) {
  std::vector<Trial> trials;
  const double most_px = kLargestPart * std::min(photo.cols, photo.rows);
  const auto size_px = [](double step) { return kLeastTried_px * std::pow(kFactor, step); };
  while (size_px(double(trials.size())) < most_px) trials.push_back(tried(photo, size_px(double(trials.size()))));
  const auto best = std::max_element(trials.begin(), trials.end(),
                                     [](const Trial& a, const Trial& b) { return a.support < b.support; });
  if (best == trials.end() || best->support < kLeastSupport) return 0;
  const bool is_inside = best != trials.begin() && best + 1 != trials.end();
  const double step =
      double(best - trials.begin()) + (is_inside ? peak(best[-1].support, best->support, best[1].support) : 0);
  // Elements of a clear outline are found at sizes much below their own, too.
  return std::max(size_px(step), best->side_px);
}

}  // namespace tessera
