#include "products/elements/gap_filter.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "products/elements/gap_appearance.h"
#include "products/elements/segmentation/region_labels.h"

namespace tessera {
namespace {

constexpr double kLeastGap = 0.02;  // part of the picture
constexpr int kLeastElement_px2 = 100;
/// An element that looks like gap is surrounded by gap for more than this part of its boundary,
constexpr double kLeastOpen = 0.5;
/// and differs from that gap by more than this part of the usual difference.
constexpr double kLeastContrast = 0.5;

struct Surroundings {
  double open = 0;      // part of the ring around the region that is gap
  double contrast = 0;  // between the region's inside and that gap: CIELAB, a and b times 1.5
};

Surroundings surroundings_of(const cv::Mat& labels, const cv::Mat& lab, int label, const cv::Rect& box) {
  constexpr int kRing_px = 6;
  const cv::Rect part = grown_within(box, kRing_px + 1, labels.size());
  const cv::Mat mask = labels(part) == label;
  cv::Mat inside, touching, reach;
  cv::erode(mask, inside, round_window(5));
  cv::dilate(mask, touching, round_window(3));
  cv::dilate(mask, reach, round_window(2 * kRing_px + 1));
  const cv::Mat ring = reach & ~touching;
  const cv::Mat open = ring & (labels(part) == 0);
  const cv::Scalar difference = cv::mean(lab(part), inside) - cv::mean(lab(part), open);
  return {double(cv::countNonZero(open)) / std::max(1, cv::countNonZero(ring)),
          std::hypot(difference[0], 1.5 * difference[1], 1.5 * difference[2])};
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<Surroundings> all_surroundings(const cv::Mat& labels, const cv::Mat& lab,
                                           const std::vector<RegionBox>& regions) {
  std::vector<Surroundings> surroundings(regions.size());
  for (std::size_t i = 1; i < regions.size(); ++i) {
    surroundings[i] = surroundings_of(labels, lab, int(i), regions[i].box);
  }
  return surroundings;
}

/// The usual contrast of regions that do not look like gap.
double usual_contrast(const std::vector<Surroundings>& surroundings, const std::vector<char>& is_like_gap) {
  std::vector<double> contrasts;
  for (std::size_t i = 1; i < surroundings.size(); ++i) {
    if (surroundings[i].open > kLeastOpen && !is_like_gap[i]) contrasts.push_back(surroundings[i].contrast);
  }
  return median_of(contrasts);
}

}  // namespace

cv::Mat without_gap_regions(const cv::Mat& labels, const cv::Mat& bgr, const cv::Mat& lab) {
  const cv::Mat window = cv::Mat::ones(3, 3, CV_8U);
  cv::Mat gap, element;
  cv::erode(labels == 0, gap, window);
  cv::erode(labels > 0, element, window);
  const cv::Mat features = appearance_features(bgr);
  const std::vector<RegionBox> regions = region_boxes(labels);
  const std::vector<Surroundings> surroundings = all_surroundings(labels, lab, regions);
  cv::Mat kept = labels.clone();
  // Twice, because the regions that the first round finds to be gap improve the model of the gap.
  for (int round = 0; round < 2; ++round) {
    if (cv::countNonZero(gap) < kLeastGap * double(labels.total())) break;
    if (cv::countNonZero(element) < kLeastElement_px2) break;
    const std::vector<char> is_like_gap = are_like_gap(labels, features, gap, element);
    const double least_contrast = kLeastContrast * usual_contrast(surroundings, is_like_gap);
    for (std::size_t i = 1; i < regions.size(); ++i) {
      const bool stands_apart = surroundings[i].open > kLeastOpen && surroundings[i].contrast > least_contrast;
      if (!is_like_gap[i] || stands_apart) continue;
      const cv::Rect box = regions[i].box;
      const cv::Mat region = labels(box) == int(i);
      kept(box).setTo(0, region);
      gap(box).setTo(255, region);
      element(box).setTo(0, region);
    }
  }
  return solid_regions(kept, 0, 0);
}

}  // namespace tessera
