#include "io/artwork/alpha.h"

#include <algorithm>

namespace tessera::io {
namespace {

/// `convert(colour, alpha)` for the three colours of every pixel, alpha above 0; clear pixels become 0.
template <class Convert>
cv::Mat converted(const cv::Mat& image, Convert convert) {
  CV_Assert(image.type() == CV_8UC4);
  cv::Mat result(image.size(), CV_8UC4);
  for (int y = 0; y < image.rows; ++y) {
    const auto* from = image.ptr<cv::Vec4b>(y);
    auto* to = result.ptr<cv::Vec4b>(y);
    for (int x = 0; x < image.cols; ++x) {
      const int alpha = from[x][3];
      for (int c = 0; c < 3; ++c) to[x][c] = alpha ? std::uint8_t(convert(from[x][c], alpha)) : 0;
      to[x][3] = std::uint8_t(alpha);
    }
  }
  return result;
}

}  // namespace

cv::Mat premultiplied(const cv::Mat& straight) {
  return converted(straight, [](int colour, int alpha) { return (colour * alpha + 127) / 255; });
}

cv::Mat straightened(const cv::Mat& premultiplied) {
  return converted(premultiplied,
                   [](int colour, int alpha) { return std::min(255, (colour * 255 + alpha / 2) / alpha); });
}

}  // namespace tessera::io
