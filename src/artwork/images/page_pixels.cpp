#include "artwork/images/page_pixels.h"

#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace tessera {

cv::Mat connected_to_edge(const cv::Mat& open) {
  constexpr std::uint8_t kReached = 128;
  cv::Mat reached;  // with an open rim, through which the whole edge is connected
  cv::copyMakeBorder(open, reached, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(255));
  cv::floodFill(reached, cv::Point(0, 0), cv::Scalar(kReached));
  return reached(cv::Rect(1, 1, open.cols, open.rows)) == kReached;
}

cv::Mat square(int radius_px) { return cv::Mat::ones(2 * radius_px + 1, 2 * radius_px + 1, CV_8U); }

}  // namespace tessera
