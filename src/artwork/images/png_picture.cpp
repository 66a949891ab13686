#include "artwork/images/png_picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "artwork/images/alpha.h"
#include "artwork/images/formats/image_readers.h"
#include "artwork/images/image_header.h"
#include "core/base/error.h"

namespace tessera {
namespace {

/// Most pixels of a PNG. A finished collage may have very many: the limit is the process' memory.
constexpr double kMostPixels = 1 << 30;

cv::Mat decoded(std::span<const std::uint8_t> bytes, const std::string& path) {
  if (image_format(bytes) != ImageFormat::png) throw InputError(path + ": not a PNG file");
  try {
    const cv::Mat pixels = read_png(bytes, {.bits = PixelBits::as_stored, .most_pixels = kMostPixels}).pixels;
    if (pixels.depth() == CV_8U) return pixels;
  } catch (const UnreadableImage& error) {
    throw InputError(path + ": " + error.what());
  }
  throw InputError(path + ": a PNG of 16 bits a channel, needed: 8");
}

}  // namespace

cv::Mat shrunk(const cv::Mat& image, int longest_side_px) {
  const double scale = double(longest_side_px) / std::max(image.cols, image.rows);
  if (scale >= 1) return image;
  const cv::Size size(std::max(1, cvRound(image.cols * scale)), std::max(1, cvRound(image.rows * scale)));
  cv::Mat small;
  if (image.channels() == 4) {
    cv::resize(premultiplied(image), small, size, 0, 0, cv::INTER_AREA);
    return straightened(small);
  }
  cv::resize(image, small, size, 0, 0, cv::INTER_AREA);
  return small;
}

cv::Mat png_picture(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px) {
  const cv::Mat image = shrunk(decoded(bytes, path), longest_side_px);
  if (image.channels() == 4) return image;
  cv::Mat bgra;
  cv::cvtColor(image, bgra, image.channels() == 1 ? cv::COLOR_GRAY2BGRA : cv::COLOR_BGR2BGRA);
  return bgra;
}

}  // namespace tessera
