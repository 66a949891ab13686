#include "artwork/images/alpha.h"

#include <algorithm>

namespace tessera {
namespace {

/// Applies `convert(colour, alpha)` to the three colours of every pixel with alpha above 0; clear pixels become 0.
template <class Convert>
void convert_colours(cv::Mat& image, Convert convert) {
  CV_Assert(image.type() == CV_8UC4);
  for (int y = 0; y < image.rows; ++y) {
    auto* row = image.ptr<cv::Vec4b>(y);
    for (int x = 0; x < image.cols; ++x) {
      const int alpha = row[x][3];
      for (int c = 0; c < 3; ++c) row[x][c] = alpha ? std::uint8_t(convert(row[x][c], alpha)) : 0;
    }
  }
}

}  // namespace

void premultiply(cv::Mat& straight) {
  convert_colours(straight, [](int colour, int alpha) { return (colour * alpha + 127) / 255; });
}

cv::Mat premultiplied(const cv::Mat& straight) {
  cv::Mat result = straight.clone();
  premultiply(result);
  return result;
}

void straighten(cv::Mat& premultiplied) {
  convert_colours(premultiplied,
                  [](int colour, int alpha) { return std::min(255, (colour * 255 + alpha / 2) / alpha); });
}

cv::Mat straightened(const cv::Mat& premultiplied) {
  cv::Mat result = premultiplied.clone();
  straighten(result);
  return result;
}

}  // namespace tessera
