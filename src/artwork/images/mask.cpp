#include "artwork/images/mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "artwork/images/page_pixels.h"
#include "artwork/images/picture_ground.h"

namespace tessera {
namespace {

/// A pixel inside a mask's shape is odd where it differs from the shape's mean colour by more than this, of 255. The
/// noise of a JPEG stays below.
constexpr double kMostNoise = 40;
/// A mask has at most this part of odd pixels; the whole is the number of pixels of its shape.
constexpr double kMostOddPixels = 0.01;
/// Pixels within this distance of the shape's outline have mixed colours and are never counted as odd.
constexpr int kEdge_px = 3;
/// Two pixels of the picture's edge have the same colour where they differ by less than this, of 255.
constexpr double kLeastEdgeContrast = 16;
/// An edge is plain where at most this part of its pixels has neither of its two most frequent colours. Masks measured
/// 0.00; six photos measured 0.39 to 0.66.
constexpr double kMostOddEdge = 0.25;

/// Largest difference of the three colours, CV_8U.
cv::Mat difference_from(const cv::Mat& bgr, const cv::Vec3d& colour) {
  cv::Mat difference;
  cv::absdiff(bgr, cv::Scalar(colour[0], colour[1], colour[2]), difference);
  std::array<cv::Mat, 3> channel;
  cv::split(difference, channel.data());
  return cv::max(cv::max(channel[0], channel[1]), channel[2]);
}

/// The pixels that differ from the background, by Otsu's threshold.
struct ShapePixels {
  cv::Mat is_shape;       // CV_8U, 255 or 0
  double shape_mean = 0;  // mean difference, of 255
  double background_mean = 0;

  bool stand_out() const { return shape_mean - background_mean >= kGroundNoise; }
};

ShapePixels shape_pixels(const cv::Mat& difference) {
  ShapePixels pixels;
  cv::threshold(difference, pixels.is_shape, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
  pixels.shape_mean = cv::mean(difference, pixels.is_shape)[0];
  pixels.background_mean = cv::mean(difference, ~pixels.is_shape)[0];
  return pixels;
}

/// Whether the picture has only two colours away from edges: then holes in the shape show the background.
bool has_two_colours(const cv::Mat& bgr, const cv::Mat& difference, const ShapePixels& pixels) {
  cv::Mat shape, background, smooth;
  cv::erode(pixels.is_shape, shape, square(kEdge_px));
  cv::erode(~pixels.is_shape, background, square(kEdge_px));
  const cv::Scalar mean = cv::mean(bgr, shape);
  const cv::Mat odd_in_shape = shape & (difference_from(bgr, {mean[0], mean[1], mean[2]}) > kMostNoise);
  cv::blur(difference, smooth, {kEdge_px, kEdge_px});  // removes ringing of a JPEG beside lines
  const cv::Mat odd_in_background = background & (smooth > kGroundNoise);
  const int odd = cv::countNonZero(odd_in_shape) + cv::countNonZero(odd_in_background);
  return odd <= kMostOddPixels * cv::countNonZero(pixels.is_shape);
}

/// Alpha that rises from 0 at the background's mean difference to 255 at the shape's.
cv::Mat alpha_by_colour(const cv::Mat& difference, const ShapePixels& pixels) {
  cv::Mat alpha;
  const double slope = 255 / (pixels.shape_mean - pixels.background_mean);
  difference.convertTo(alpha, CV_8U, slope, -pixels.background_mean * slope);  // saturates
  return alpha;
}

cv::Mat alpha_of(const cv::Mat& bgr, const cv::Vec3d& background) {
  const cv::Mat difference = difference_from(bgr, background);
  const ShapePixels pixels = shape_pixels(difference);
  if (!pixels.stand_out()) return cv::Mat::zeros(difference.size(), CV_8U);
  if (has_two_colours(bgr, difference, pixels)) return alpha_by_colour(difference, pixels);
  return alpha_beside_ground(ground_of(difference), difference);
}

std::vector<cv::Vec3b> edge_pixels(const cv::Mat& bgr) {
  std::vector<cv::Vec3b> pixels;
  for (int x = 0; x < bgr.cols; ++x) {
    pixels.push_back(bgr.at<cv::Vec3b>(0, x));
    pixels.push_back(bgr.at<cv::Vec3b>(bgr.rows - 1, x));
  }
  for (int y = 0; y < bgr.rows; ++y) {
    pixels.push_back(bgr.at<cv::Vec3b>(y, 0));
    pixels.push_back(bgr.at<cv::Vec3b>(y, bgr.cols - 1));
  }
  return pixels;
}

/// Mean of the pixels in the fullest of 16 x 16 x 16 colour bins. `pixels` must not be empty.
cv::Vec3d prevailing_colour(const std::vector<cv::Vec3b>& pixels) {
  struct Bin {
    cv::Vec3d sum{0, 0, 0};
    int count = 0;
  };
  std::vector<Bin> bins(16 * 16 * 16);
  for (const cv::Vec3b& c : pixels) {
    Bin& bin = bins[std::size_t(c[0] >> 4 << 8 | c[1] >> 4 << 4 | c[2] >> 4)];
    bin.sum += cv::Vec3d(c);
    ++bin.count;
  }
  const Bin& best = *std::max_element(bins.begin(), bins.end(), [](auto& a, auto& b) { return a.count < b.count; });
  return best.sum / best.count;
}

/// The colour that gives `seen` when it is mixed with the background.
std::uint8_t unmixed(double seen, double background, int alpha) {
  return alpha == 0 ? 0 : cv::saturate_cast<std::uint8_t>(background + (seen - background) * 255 / alpha);
}

}  // namespace

cv::Vec3d prevailing_edge_colour(const cv::Mat& bgr) { return prevailing_colour(edge_pixels(bgr)); }

bool has_plain_edge(const cv::Mat& bgr) {
  std::vector<cv::Vec3b> pixels = edge_pixels(bgr);
  const std::size_t all = pixels.size();
  for (int colour = 0; colour < 2 && !pixels.empty(); ++colour) {
    const cv::Vec3d prevailing = prevailing_colour(pixels);
    std::erase_if(pixels, [&](const cv::Vec3b& pixel) {
      return cv::norm(cv::Vec3d(pixel) - prevailing, cv::NORM_INF) < kLeastEdgeContrast;
    });
  }
  return double(pixels.size()) <= kMostOddEdge * double(all);
}

cv::Mat cut_from_background(const cv::Mat& bgr) {
  const cv::Vec3d background = prevailing_edge_colour(bgr);
  const cv::Mat alpha = alpha_of(bgr, background);
  cv::Mat result(bgr.size(), CV_8UC4);
  for (int y = 0; y < bgr.rows; ++y) {
    for (int x = 0; x < bgr.cols; ++x) {
      const cv::Vec3b seen = bgr.at<cv::Vec3b>(y, x);
      const int a = alpha.at<std::uint8_t>(y, x);
      cv::Vec4b& out = result.at<cv::Vec4b>(y, x);
      for (int c = 0; c < 3; ++c) out[c] = unmixed(seen[c], background[c], a);
      out[3] = std::uint8_t(a);
    }
  }
  return result;
}

}  // namespace tessera
