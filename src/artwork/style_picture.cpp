#include "artwork/style_picture.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "artwork/images/colour_conversion.h"

namespace tessera {
namespace {

const cv::Scalar kTransparentWhite(255, 255, 255, 0);

/// The drawing over white, with its alpha and a white margin.
cv::Mat on_white(const cv::Mat& premultiplied) {
  cv::Mat over(premultiplied.size(), CV_8UC4);
  for (int y = 0; y < over.rows; ++y) {
    for (int x = 0; x < over.cols; ++x) {
      const cv::Vec4b& from = premultiplied.at<cv::Vec4b>(y, x);
      const int white = 255 - from[3];
      cv::Vec4b& to = over.at<cv::Vec4b>(y, x);
      for (int c = 0; c < 3; ++c) to[c] = cv::saturate_cast<std::uint8_t>(from[c] + white);
      to[3] = from[3];
    }
  }
  cv::copyMakeBorder(over, over, 1, 1, 1, 1, cv::BORDER_CONSTANT, kTransparentWhite);
  return over;
}

Grid<std::uint8_t> inside_of(const cv::Mat& picture) {
  Grid<float> alpha(picture.cols, picture.rows);
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) alpha(x, y) = float(picture.at<cv::Vec4b>(y, x)[3]) / 255;
  }
  return enclosed_by(alpha);
}

double scale_for(const cv::Mat& picture, double unit_px) {
  return std::min(kStyleUnit_px / unit_px, double(kMostStyleSide_px) / std::max(picture.cols, picture.rows));
}

cv::Mat scaled(const cv::Mat& picture, double scale) {
  const cv::Size size(std::max(1, cvRound(picture.cols * scale)), std::max(1, cvRound(picture.rows * scale)));
  cv::Mat result;
  cv::resize(picture, result, size, 0, 0, scale < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
  constexpr int m = kStyleMargin_px;
  cv::copyMakeBorder(result, result, m, m, m, m, cv::BORDER_CONSTANT, kTransparentWhite);
  return result;
}

Grid<Lab> colours_of(const cv::Mat& picture) {
  const cv::Mat lab = lab_image_of(picture);
  Grid<Lab> colours(lab.cols, lab.rows);
  for (int y = 0; y < lab.rows; ++y) {
    for (int x = 0; x < lab.cols; ++x) {
      const cv::Vec3f& c = lab.at<cv::Vec3f>(y, x);
      colours(x, y) = {c[0], c[1], c[2]};
    }
  }
  return colours;
}

}  // namespace

StyleRaster style_raster_of(const cv::Mat& premultiplied) {
  if (premultiplied.empty()) return {};
  const cv::Mat white = on_white(premultiplied);
  const Grid<std::uint8_t> inside = inside_of(white);
  const double unit_px = std::sqrt(std::accumulate(inside.data().begin(), inside.data().end(), 0.0));
  if (unit_px == 0) return {};
  const double scale = scale_for(white, unit_px);
  const cv::Mat picture = scaled(white, scale);
  return {colours_of(picture), inside_of(picture), float(unit_px * scale)};
}

}  // namespace tessera
