#include "render/shown_picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <span>

#include "artwork/images/alpha.h"
#include "artwork/images/image_header.h"
#include "artwork/images/png_picture.h"
#include "core/base/error.h"
#include "job/canvas/overlays.h"
#include "layers/svg_image.h"
#include "render/pieces/piece_drawing.h"
#include "result/folder/result_file.h"
#include "text/number_text.h"

namespace tessera {
namespace {

/// Size of the background: it is soft, because details would compete with the drawings.
constexpr int kLongestBackgroundSide_px = 1024;
constexpr int kCanvasPxPerBackgroundPixel = 2;
/// Enough for a PNG of kLongestShownSide_px in each direction.
constexpr std::size_t kMostBytes = std::size_t(16) << 20;
constexpr const char* kBackgroundId = "shown-picture";        // the pattern has "ground"
constexpr const char* kOverlayPictureId = "overlay-picture";  // the pattern has "overlay"

/// Multiplies colours by `light`, but makes dark ones lighter: dark pieces would not stand out from an even darker ground.
void darken(cv::Mat& opaque_bgra, double light) {
  constexpr double kDark = 64;   // the grey from which nothing is lightened
  constexpr double kLift = 160;  // added to black: 26 of 255 at a light of 0.8
  cv::Mat grey;
  cv::cvtColor(opaque_bgra, grey, cv::COLOR_BGRA2GRAY);
  for (int y = 0; y < opaque_bgra.rows; ++y) {
    for (int x = 0; x < opaque_bgra.cols; ++x) {
      const double lift = kLift * light * (1 - light) * std::max(0., 1 - grey.at<std::uint8_t>(y, x) / kDark);
      cv::Vec4b& pixel = opaque_bgra.at<cv::Vec4b>(y, x);
      for (int channel = 0; channel < 3; ++channel) {
        pixel[channel] = cv::saturate_cast<std::uint8_t>(light * pixel[channel] + lift);
      }
    }
  }
}

/// Refuses sizes that would fill the memory, because a small file may claim any size. Throws InputError.
void check_size(std::span<const std::uint8_t> png, const std::string& path) {
  const std::optional<cv::Size2d> size = image_size_from_header(png);
  if (!size || std::max(size->width, size->height) <= kLongestShownSide_px) return;
  throw InputError(path + ": found " + fixed(size->width, 0) + " x " + fixed(size->height, 0) +
                   " px, allowed: at most " + std::to_string(kLongestShownSide_px) + " px each way");
}

/// The picture in the folder; see shown_picture().
cv::Mat picture_in(const std::string& dir, int longest_side_px) {
  if (!is_in_result(dir, kShownPictureName)) return {};
  const std::string text = read_result_file(dir, kShownPictureName, kMostBytes);
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  const std::string path = path_in_result(dir, kShownPictureName);
  check_size(bytes, path);
  return png_picture(bytes, path, longest_side_px);
}

/// The picture that the result must have. `found`: the key that asks for it and its value.
cv::Mat kept_picture(const std::string& dir, const std::string& found, int longest_side_px) {
  cv::Mat picture = picture_in(dir, longest_side_px);
  if (!picture.empty()) return picture;
  throw InputError(found + ", but " + path_in_result(dir, kShownPictureName) +
                   " is missing; needed: the result of a job with colour.image, made by this version or a later one");
}

int background_side_px(const Canvas& canvas) {
  const int longest_px = std::max(canvas.width_px, canvas.height_px);
  return std::clamp(longest_px / kCanvasPxPerBackgroundPixel, 1, kLongestBackgroundSide_px);
}

/// The picture laid on white, opaque.
cv::Mat on_white(const cv::Mat& bgra) {
  cv::Mat laid(bgra.size(), CV_8UC4, cv::Scalar::all(255));
  lay_over(premultiplied(bgra), laid);
  return laid;
}

/// A tile of the picture (straight BGRA) over the whole canvas.
GroundTile over_canvas(const cv::Mat& bgra, const char* id, const Canvas& canvas) {
  GroundTile tile;
  tile.page = premultiplied(bgra);
  tile.size_px = cv::Size2d(canvas.width_px, canvas.height_px);
  tile.repeats = false;
  tile.svg = svg_image(bgra, id);
  tile.svg_size = bgra.size();
  return tile;
}

}  // namespace

cv::Mat shown_picture(const std::string& dir) { return picture_in(dir, kLongestShownSide_px); }

std::string flat_background(const OutputSpec& output) {
  const bool is_picture = output.background == kImageBackground || output.background == kPhotoBackground;
  return is_picture ? "#ffffff" : output.background;
}

GroundTile image_background(const std::string& dir, const OutputSpec& output, const Canvas& canvas) {
  const std::string found = "output.background: found \"" + std::string(kImageBackground) + "\"";
  cv::Mat picture = on_white(kept_picture(dir, found, background_side_px(canvas)));
  darken(picture, output.background_light);
  return over_canvas(picture, kBackgroundId, canvas);
}

GroundTile image_overlay(const std::string& dir, double opacity, const Canvas& canvas) {
  if (opacity == 0) return {};
  const std::string found = "colour.overlay: found " + significant(opacity, 3);
  GroundTile tile = over_canvas(kept_picture(dir, found, kLongestShownSide_px), kOverlayPictureId, canvas);
  tile.page *= opacity;
  return tile;
}

}  // namespace tessera
