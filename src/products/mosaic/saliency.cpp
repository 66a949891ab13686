#include "products/mosaic/saliency.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"

namespace tessera {
namespace {

/// An ellipse with its saliency; lengths are parts of a face's box.
struct Spot {
  double x, y, radius_x, radius_y;
  double saliency;
};

/// The parts by which a face is recognised, at fixed places: cascades of eyes would find them less surely. All lie within
/// kFace.
constexpr Spot kFace{0.5, 0.5, 0.46, 0.58, 0.3};
constexpr Spot kEyesAndMouth[] = {
    {0.29, 0.37, 0.17, 0.12, 0.8}, {0.71, 0.37, 0.17, 0.12, 0.8}, {0.5, 0.79, 0.23, 0.12, 0.8}};
/// The part of an ellipse's radius over which saliency falls to 0 outside it.
constexpr double kBorder = 0.4;

/// Width in smallest pieces: a wider face needs less saliency.
constexpr double kNeedyWidth = 16;

/// The largest difference of the channels of a grey picture, as JPEG may cause it.
constexpr int kMostColour = 24;

/// 1 inside the ellipse, 0 outside, with a soft border.
double within(const Spot& spot, cv::Point2d at) {
  const double x = (at.x - spot.x) / spot.radius_x, y = (at.y - spot.y) / spot.radius_y;
  const double out = std::clamp((std::sqrt(x * x + y * y) - 1) / kBorder, 0., 1.);
  return 1 - out * out * (3 - 2 * out);
}

/// The saliency of a face. `at`: in parts of its box.
double saliency_at(cv::Point2d at) {
  double saliency = kFace.saliency * within(kFace, at);
  for (const Spot& spot : kEyesAndMouth) saliency = std::max(saliency, spot.saliency * within(spot, at));
  return saliency;
}

/// The px of a map of `size` where `face` has any saliency.
cv::Rect reach_of(const Face& face, cv::Size size) {
  const double beyond_x = kFace.radius_x * (1 + kBorder), beyond_y = kFace.radius_y * (1 + kBorder);
  const auto x = [&](double at) { return int(std::floor((face.box.x + at * face.box.width) * size.width)); };
  const auto y = [&](double at) { return int(std::floor((face.box.y + at * face.box.height) * size.height)); };
  const cv::Point first(x(kFace.x - beyond_x), y(kFace.y - beyond_y));
  const cv::Point last(x(kFace.x + beyond_x), y(kFace.y + beyond_y));
  return cv::Rect(first, last + cv::Point(1, 1)) & cv::Rect({}, size);
}

void add_face(const Face& face, double smallest_px, cv::Mat& saliency) {
  const double need = std::min(1., kNeedyWidth * smallest_px / (face.box.width * saliency.cols));
  const cv::Rect reach = reach_of(face, saliency.size());
  for (int y = reach.y; y < reach.br().y; ++y) {
    for (int x = reach.x; x < reach.br().x; ++x) {
      const cv::Point2d at(((x + 0.5) / saliency.cols - face.box.x) / face.box.width,
                           ((y + 0.5) / saliency.rows - face.box.y) / face.box.height);
      float& here = saliency.at<float>(y, x);
      here = std::max(here, float(face.certainty * need * saliency_at(at)));
    }
  }
}

void check_is_grey(const cv::Mat& bgra) {
  for (int y = 0; y < bgra.rows; ++y) {
    for (int x = 0; x < bgra.cols; ++x) {
      const cv::Vec4b& p = bgra.at<cv::Vec4b>(y, x);
      const auto [least, most] = std::minmax({p[0], p[1], p[2]});
      if (p[3] == 0 || most - least <= kMostColour) continue;
      throw InputError(
          cv::format("found the colour #%02x%02x%02x at (%d, %d) px, allowed: a grey picture, white where "
                     "pieces are to be small, black where the image alone decides",
                     p[2], p[1], p[0], x, y));
    }
  }
}

}  // namespace

cv::Mat saliency_of_faces(const std::vector<Face>& faces, cv::Size size, double smallest_px) {
  cv::Mat saliency(size, CV_32F, cv::Scalar(0));
  for (const Face& face : faces) add_face(face, smallest_px, saliency);
  return saliency;
}

cv::Mat saliency_of_picture(const cv::Mat& bgra, cv::Size size) {
  check_is_grey(bgra);
  cv::Mat grey, alpha, saliency;
  cv::cvtColor(bgra, grey, cv::COLOR_BGRA2GRAY);
  cv::extractChannel(bgra, alpha, 3);
  cv::multiply(grey, alpha, grey, 1. / 255);
  const bool shrinks = grey.cols > size.width || grey.rows > size.height;
  cv::resize(grey, grey, size, 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  grey.convertTo(saliency, CV_32F, 1. / 255);
  return saliency;
}

}  // namespace tessera
