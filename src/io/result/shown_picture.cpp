#include "io/result/shown_picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <span>

#include "core/base/error.h"
#include "io/artwork/png_picture.h"
#include "io/elements/cut_outs.h"
#include "io/result/result_file.h"
#include "io/result/svg_image.h"

namespace tessera::io {
namespace {

constexpr int kLongestSide_px = 1024;
/// Of such a PNG, and far more.
constexpr std::size_t kMostBytes = std::size_t(16) << 20;
constexpr const char* kId = "shown-picture";

/// Lightness, a and b, CV_32FC3, and what is opaque, CV_8U.
struct LabPicture {
  cv::Mat lab, alpha;
};

LabPicture lab_picture(const ColourTarget& target, const Canvas& canvas, cv::Size size) {
  const float width_px = float(canvas.width_px) / float(size.width);
  const float height_px = float(canvas.height_px) / float(size.height);
  const int level = target.level_for(std::max(width_px, height_px));
  LabPicture picture{cv::Mat(size, CV_32FC3), cv::Mat(size, CV_8U)};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Texel texel = target.at(level, {(float(x) + 0.5f) * width_px, (float(y) + 0.5f) * height_px});
      const bool wished = texel.weight >= kLeastColourWeight;
      const Lab lab = wished ? texel.colour() : Lab{100, 0, 0};
      picture.lab.at<cv::Vec3f>(y, x) = {lab.lightness, lab.a, lab.b};
      picture.alpha.at<std::uint8_t>(y, x) = wished ? cv::saturate_cast<std::uint8_t>(255 * texel.weight) : 0;
    }
  }
  return picture;
}

/// On white.
cv::Mat opaque(const cv::Mat& bgra) {
  cv::Mat bgr(bgra.size(), CV_8UC3);
  for (int y = 0; y < bgra.rows; ++y) {
    for (int x = 0; x < bgra.cols; ++x) {
      const cv::Vec4b& pixel = bgra.at<cv::Vec4b>(y, x);
      for (int c = 0; c < 3; ++c) {
        bgr.at<cv::Vec3b>(y, x)[c] = std::uint8_t((pixel[c] * pixel[3] + 255 * (255 - pixel[3]) + 127) / 255);
      }
    }
  }
  return bgr;
}

/// Times `light`; but what is dark becomes lighter: dark pieces would not stand out from what is darker still.
void darken(cv::Mat& bgr, double light) {
  constexpr double kDark = 64;   // a grey from which on nothing is lightened
  constexpr double kLift = 160;  // of black: 26 of 255 at a light of 0.8
  cv::Mat grey;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  for (int y = 0; y < bgr.rows; ++y) {
    for (int x = 0; x < bgr.cols; ++x) {
      const double lift = kLift * light * (1 - light) * std::max(0., 1 - grey.at<std::uint8_t>(y, x) / kDark);
      cv::Vec3b& pixel = bgr.at<cv::Vec3b>(y, x);
      for (int channel = 0; channel < 3; ++channel) {
        pixel[channel] = cv::saturate_cast<std::uint8_t>(light * pixel[channel] + lift);
      }
    }
  }
}

cv::Size size_for(const Canvas& canvas) {
  const double scale = std::min(1., double(kLongestSide_px) / std::max(canvas.width_px, canvas.height_px));
  return {std::max(1, cvRound(canvas.width_px * scale)), std::max(1, cvRound(canvas.height_px * scale))};
}

}  // namespace

std::vector<std::uint8_t> shown_picture_png(const ColourTarget& target, const Canvas& canvas) {
  const LabPicture seen = lab_picture(target, canvas, size_for(canvas));
  cv::Mat picture;
  cv::cvtColor(seen.lab, picture, cv::COLOR_Lab2BGR);
  picture.convertTo(picture, CV_8U, 255);
  if (cv::countNonZero(seen.alpha != 255) == 0) return png_of(picture);
  cv::Mat bgra;
  cv::merge(std::vector<cv::Mat>{picture, seen.alpha}, bgra);
  return png_of(bgra);
}

cv::Mat shown_picture(const std::string& dir) {
  if (!is_in_result(dir, kShownPictureName)) return {};
  const std::string text = read_result_file(dir, kShownPictureName, kMostBytes);
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  return png_picture(bytes, path_in_result(dir, kShownPictureName), kLongestSide_px);
}

std::string flat_background(const OutputSpec& output) {
  return output.background == kImageBackground ? "#ffffff" : output.background;
}

GroundTile image_background(const std::string& dir, const OutputSpec& output, const Canvas& canvas) {
  const cv::Mat shown = shown_picture(dir);
  if (shown.empty()) {
    throw InputError("output.background: found \"" + std::string(kImageBackground) + "\", but " +
                     path_in_result(dir, kShownPictureName) + " is missing; needed: the result of a job with " +
                     "colour.image, made by this version or a later one");
  }
  cv::Mat bgr = opaque(shown);
  darken(bgr, output.background_light);
  GroundTile tile;
  cv::cvtColor(bgr, tile.page, cv::COLOR_BGR2BGRA);  // opaque, so that it is premultiplied, too
  tile.size_px = cv::Size2d(canvas.width_px, canvas.height_px);
  tile.repeats = false;
  tile.svg = svg_image(tile.page, kId);
  tile.svg_size = tile.page.size();
  return tile;
}

}  // namespace tessera::io
