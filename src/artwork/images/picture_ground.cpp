#include "artwork/images/picture_ground.h"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "artwork/images/page_pixels.h"

namespace tessera {
namespace {

constexpr int kBand_px = 2;

}  // namespace

cv::Mat ground_of(const cv::Mat& difference) { return connected_to_edge(difference <= kGroundNoise); }

cv::Mat alpha_beside_ground(const cv::Mat& ground, const cv::Mat& difference) {
  cv::Mat reach, shown = difference.clone(), largest;
  cv::dilate(ground, reach, square(kBand_px));
  shown.setTo(0, ground);
  cv::dilate(shown, largest, square(kBand_px));
  cv::Mat alpha = cv::Mat::zeros(ground.size(), CV_8U);
  alpha.setTo(255, ~ground);
  for (int y = 0; y < ground.rows; ++y) {
    for (int x = 0; x < ground.cols; ++x) {
      if (ground.at<std::uint8_t>(y, x) || !reach.at<std::uint8_t>(y, x)) continue;
      const int most = std::max<int>(1, largest.at<std::uint8_t>(y, x));
      alpha.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(255. * shown.at<std::uint8_t>(y, x) / most);
    }
  }
  return alpha;
}

}  // namespace tessera
