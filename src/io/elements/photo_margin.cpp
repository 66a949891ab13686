#include "io/elements/photo_margin.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>

namespace tessera::io {
namespace {

/// Of the square root of an element's area: how wide a margin may be, and how far its inside lies from its edge.
constexpr double kMostMargin = 0.08;
constexpr double kInside = 0.12;

std::map<int, cv::Rect> boxes_at_edge(const cv::Mat& labels) {
  std::map<int, cv::Rect> boxes;
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      const int label = labels.at<int>(y, x);
      if (label <= 0) continue;
      cv::Rect& box = boxes.try_emplace(label, x, y, 1, 1).first->second;
      box |= cv::Rect(x, y, 1, 1);
    }
  }
  std::erase_if(boxes, [&](const auto& entry) {
    const cv::Rect& box = entry.second;
    return box.x > 0 && box.y > 0 && box.br().x < labels.cols && box.br().y < labels.rows;
  });
  return boxes;
}

/// Pixels of the window that are so near to the edges of the photo which the element reaches.
cv::Mat near_edges(const cv::Rect& window, const cv::Rect& box, const cv::Size& photo, int margin_px) {
  cv::Mat near = cv::Mat::zeros(window.size(), CV_8U);
  const auto mark = [&](const cv::Rect& strip) { near((strip & window) - window.tl()).setTo(255); };
  if (box.x == 0) mark({0, 0, margin_px, photo.height});
  if (box.y == 0) mark({0, 0, photo.width, margin_px});
  if (box.br().x == photo.width) mark({photo.width - margin_px, 0, margin_px, photo.height});
  if (box.br().y == photo.height) mark({0, photo.height - margin_px, photo.width, margin_px});
  return near;
}

cv::Mat distances_from(const cv::Mat& bgr, const cv::Scalar& colour) {
  cv::Mat difference;
  cv::absdiff(bgr, colour, difference);
  cv::transform(difference, difference, cv::Matx13f(1, 1, 1));
  return difference;
}

cv::Mat largest_part(const cv::Mat& mask) {
  cv::Mat parts, boxes, centres;
  const int count = cv::connectedComponentsWithStats(mask, parts, boxes, centres, 4);
  int largest = 0;
  for (int part = 1; part < count; ++part) {
    const auto area = [&](int i) { return i == 0 ? 0 : boxes.at<int>(i, cv::CC_STAT_AREA); };
    if (area(part) > area(largest)) largest = part;
  }
  return largest == 0 ? cv::Mat(cv::Mat::zeros(mask.size(), CV_8U)) : cv::Mat(parts == largest);
}

}  // namespace

cv::Mat without_margins(const cv::Mat& photo_bgr, const cv::Mat& labels) {
  cv::Mat result = labels.clone();
  for (const auto& [label, box] : boxes_at_edge(labels)) {
    const int reach_px = std::max(box.width, box.height) / 4 + 2;
    const cv::Rect window =
        cv::Rect(box.tl() - cv::Point(reach_px, reach_px), box.br() + cv::Point(reach_px, reach_px)) &
        cv::Rect({}, labels.size());
    const cv::Mat element = labels(window) == label, gap = labels(window) == 0, bgr = photo_bgr(window);
    const double size_px = std::sqrt(double(cv::countNonZero(element)));
    cv::Mat depth_px;
    cv::distanceTransform(element, depth_px, cv::DIST_L2, 3);
    const cv::Mat inside = depth_px > kInside * size_px;
    if (cv::countNonZero(inside) == 0 || cv::countNonZero(gap) == 0) continue;
    const cv::Mat is_gap_like = distances_from(bgr, cv::mean(bgr, gap)) < distances_from(bgr, cv::mean(bgr, inside));
    const int margin_px = std::max(1, int(kMostMargin * size_px));
    const cv::Mat margin = near_edges(window, box, labels.size(), margin_px) & element & is_gap_like;
    result(window).setTo(0, element);
    result(window).setTo(label, largest_part(element & ~margin));
  }
  return result;
}

}  // namespace tessera::io
