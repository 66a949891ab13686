#include "io/mosaic/joint_colour.h"

#include <cmath>
#include <cstdint>

namespace tessera::io {
namespace {

/// Of the mean's sRGB values. Measured on a portrait with 10 % of joints, CIEDE2000 to the image blurred by a piece: 5.3
/// for 1, 4.7 for 0.6, 4.6 for 0.36, 4.7 for black, 7.5 for white.
constexpr double kBrightness = 0.5;

double linear(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }
double encoded(double light) { return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055; }

}  // namespace

cv::Vec3b joint_colour(const cv::Mat& image_bgr) {
  double table[256];
  for (int value = 0; value < 256; ++value) table[value] = linear(value / 255.);
  double sum[3] = {};
  for (int y = 0; y < image_bgr.rows; ++y) {
    const cv::Vec3b* row = image_bgr.ptr<cv::Vec3b>(y);
    for (int x = 0; x < image_bgr.cols; ++x) {
      for (int c = 0; c < 3; ++c) sum[c] += table[row[x][c]];
    }
  }
  const auto value = [&](int channel) {
    return std::uint8_t(std::lround(kBrightness * 255 * encoded(sum[channel] / double(image_bgr.total()))));
  };
  return {value(0), value(1), value(2)};
}

}  // namespace tessera::io
