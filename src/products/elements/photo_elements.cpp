#include "products/elements/photo_elements.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "products/elements/segmentation/region_labels.h"

namespace tessera {
namespace {

/// Blur of the edge's opacity: it hides the stairs of pixels and does not move the edge.
constexpr double kEdgeBlur_px = 0.8;
/// The width of the rim beyond the edge to which colours are continued.
constexpr double kColourReach_px = 1.5;
/// The distance up to which a pixel influences the colours of the rim.
constexpr int kReach_px = 8;
/// The most pixels whose colours are made at a time.
constexpr int kMostAtATime_px2 = 1'000'000;

/// Fills places where the mask is empty with the near colours inside it.
cv::Mat colours_beyond(const cv::Mat& bgr, const cv::Mat& mask) {
  cv::Mat weight, sum;
  mask.convertTo(weight, CV_32F, 1.0 / 255);
  bgr.convertTo(sum, CV_32FC3);
  cv::Mat weights;
  cv::cvtColor(weight, weights, cv::COLOR_GRAY2BGR);
  cv::multiply(sum, weights, sum);
  cv::GaussianBlur(sum, sum, {}, kColourReach_px);
  cv::GaussianBlur(weights, weights, {}, kColourReach_px);
  cv::Mat beyond;
  cv::divide(sum, cv::max(weights, 1e-6), beyond);
  beyond.convertTo(beyond, CV_8UC3);
  bgr.copyTo(beyond, mask);
  return beyond;
}

}  // namespace

FoundElements find_elements(const LabelRuns& labels, const ElementSizes& sizes) {
  FoundElements found;
  const std::vector<RegionBox>& regions = labels.regions();
  for (std::size_t label = 1; label < regions.size(); ++label) {
    const auto& [box, area_px2] = regions[label];
    const double size_px = std::sqrt(area_px2);
    if (area_px2 == 0) continue;
    if (reaches_edge(box, labels.size())) {
      ++found.at_edge;
    } else if (size_px < sizes.least_px) {
      ++found.too_small;
    } else if (size_px > sizes.most_px) {
      ++found.too_large;
    } else if (box.area() > kMostElement_px2) {
      ++found.too_many_pixels;
    } else {
      found.elements.push_back({int(label), box, area_px2});
    }
  }
  const auto place = [](const PhotoElement& e) { return std::tuple(e.box.y, e.box.x, e.label); };
  std::sort(found.elements.begin(), found.elements.end(),
            [&](const PhotoElement& a, const PhotoElement& b) { return place(a) < place(b); });
  return found;
}

double mean_side_px(const std::vector<PhotoElement>& elements) {
  double area_px2 = 0;
  for (const PhotoElement& element : elements) area_px2 += element.area_px2;
  return std::sqrt(area_px2 / double(elements.size()));
}

cv::Mat cut_element(const cv::Mat& photo, const LabelRuns& labels, const PhotoElement& element) {
  // Beyond the photo there is only rim, because no element reaches the photo's edge.
  const cv::Rect around(element.box.tl() - cv::Point(kElementRim_px, kElementRim_px),
                        element.box.br() + cv::Point(kElementRim_px, kElementRim_px));
  const cv::Rect window = around & cv::Rect({}, photo.size());
  const cv::Mat mask = solid_part(labels.mask_of(std::size_t(element.label), window));
  cv::Mat alpha;
  cv::GaussianBlur(mask, alpha, {}, kEdgeBlur_px, kEdgeBlur_px, cv::BORDER_CONSTANT);
  cv::Mat cut = cv::Mat::zeros(around.size(), CV_8UC4);
  cv::Mat inner = cut(window - around.tl());
  const int rows_at_a_time = std::max(1, kMostAtATime_px2 / window.width);
  for (int y = 0; y < window.height; y += rows_at_a_time) {
    const cv::Range rows(y, std::min(y + rows_at_a_time, window.height));
    const cv::Range with_reach(std::max(0, rows.start - kReach_px), std::min(rows.end + kReach_px, window.height));
    const cv::Mat beyond = colours_beyond(bgr_of(photo(window).rowRange(with_reach)), mask.rowRange(with_reach));
    cv::cvtColor(beyond.rowRange(rows.start - with_reach.start, rows.end - with_reach.start), inner.rowRange(rows),
                 cv::COLOR_BGR2BGRA);
  }
  cv::insertChannel(alpha, inner, 3);
  return cut;
}

}  // namespace tessera
