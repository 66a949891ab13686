#include "io/elements/label_scaling.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "io/elements/region_labels.h"

namespace tessera::io {
namespace {

/// Smooths the steps of the copy's pixels, in its pixels.
constexpr double kSmooth_px = 0.8;
constexpr int kMargin_px = 3;

}  // namespace

cv::Mat scaled_labels(const cv::Mat& labels, cv::Size size) {
  const double scale_x = double(size.width) / labels.cols;
  const double scale_y = double(size.height) / labels.rows;
  cv::Mat scaled = cv::Mat::zeros(size, CV_32S);
  const std::vector<RegionBox> regions = region_boxes(labels);
  for (std::size_t i = 1; i < regions.size(); ++i) {
    // The frame repeats the copy's edge, so that a region cut by it stays cut there.
    const cv::Rect box = regions[i].box;
    const cv::Rect part = grown_within(box, kMargin_px, labels.size());
    cv::Mat soft;
    cv::Mat(labels(part) == int(i)).convertTo(soft, CV_32F, 1 / 255.);
    cv::GaussianBlur(soft, soft, {}, kSmooth_px, kSmooth_px, cv::BORDER_REPLICATE);
    const cv::Rect target =
        cv::Rect(cv::Point(int(std::floor(part.x * scale_x)), int(std::floor(part.y * scale_y))),
                 cv::Point(int(std::ceil(part.br().x * scale_x)), int(std::ceil(part.br().y * scale_y)))) &
        cv::Rect({0, 0}, size);
    // Pixel centres: photo (x + 0.5) / scale - 0.5 in the copy.
    const cv::Matx23d to_copy(1 / scale_x, 0, (target.x + 0.5) / scale_x - 0.5 - part.x, 0, 1 / scale_y,
                              (target.y + 0.5) / scale_y - 0.5 - part.y);
    cv::Mat fine;
    cv::warpAffine(soft, fine, to_copy, target.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
    cv::Mat there = scaled(target);
    there.setTo(int(i), (fine >= 0.5F) & (there == 0));
  }
  return solid_regions(scaled, 1, 0);
}

}  // namespace tessera::io
