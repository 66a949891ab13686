#include "products/elements/element_surroundings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "core/shape/shape.h"

namespace tessera {
namespace {

/// Wide enough that the surroundings of neighbours meet in a joint, also where an element between them was not found.
constexpr double kMargin_elements = 0.75;
constexpr int kLeastMargin_px = 16, kMostMargin_px = 512;
/// The width of an element's edge, which is not shown as ground: labels are not exact. A part of the margin, in bounds.
constexpr double kEdgeOfMargin = 0.04;
constexpr int kLeastEdge_px = 1, kMostEdge_px = 6;

}  // namespace

int surroundings_margin_px(const std::vector<PhotoElement>& elements) {
  if (elements.empty()) return kLeastMargin_px;
  const double margin_px = kMargin_elements * mean_side_px(elements);
  return std::clamp(int(std::lround(margin_px)), kLeastMargin_px, kMostMargin_px);
}

cv::Mat element_surroundings(const cv::Mat& photo, const cv::Mat& labels, const std::vector<LabelRole>& roles,
                             const PhotoElement& element, int margin_px) {
  const int more_px = kElementRim_px + margin_px;
  const cv::Rect around(element.box.tl() - cv::Point(more_px, more_px), element.box.br() + cv::Point(more_px, more_px));
  const cv::Rect window = around & cv::Rect({}, photo.size());
  cv::Mat others(window.size(), CV_8U), own(window.size(), CV_8U);
  for (int y = 0; y < window.height; ++y) {
    const int* label = labels.ptr<int>(window.y + y) + window.x;
    for (int x = 0; x < window.width; ++x) {
      const bool is_own = label[x] == element.label;
      own.at<std::uint8_t>(y, x) = is_own ? 255 : 0;
      others.at<std::uint8_t>(y, x) = !is_own && roles[std::size_t(label[x])] != LabelRole::ground ? 255 : 0;
    }
  }
  const int edge_px = std::clamp(int(std::lround(kEdgeOfMargin * margin_px)), kLeastEdge_px, kMostEdge_px);
  cv::dilate(others, others, cv::Mat::ones(2 * edge_px + 1, 2 * edge_px + 1, CV_8U));
  cv::Mat alpha(window.size(), CV_8U, cv::Scalar(kOtherElementAlpha));
  alpha.setTo(255, ~others | own);
  cv::Mat cut = cv::Mat::zeros(around.size(), CV_8UC4);
  cv::Mat inner = cut(window - around.tl());
  photo(window).copyTo(inner);
  cv::insertChannel(alpha, inner, 3);
  return cut;
}

}  // namespace tessera
