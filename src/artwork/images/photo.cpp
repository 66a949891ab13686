#include "artwork/images/photo.h"

#include <opencv2/imgproc.hpp>
#include <utility>

#include "artwork/images/image_decoding.h"
#include "artwork/images/reduced_picture.h"
#include "core/base/error.h"

namespace tessera {

namespace {

/// The pixels as they were seen: grey, or BGR without the file's alpha.
cv::Mat opaque_pixels(DecodedImage image) {
  if (image.pixels.channels() == 4) cv::cvtColor(image.pixels, image.pixels, cv::COLOR_BGRA2BGR);
  return seen_pixels(std::move(image));
}

}  // namespace

cv::Mat photo_picture(std::span<const std::uint8_t> bytes, const std::string& path, double most_pixels) {
  const cv::Mat reduced = reduced_picture(opaque_pixels(decode_image(bytes, path, PixelBits::eight)), most_pixels);
  cv::Mat bgra;
  cv::cvtColor(reduced, bgra, reduced.channels() == 1 ? cv::COLOR_GRAY2BGRA : cv::COLOR_BGR2BGRA);
  return bgra;
}

cv::Mat label_picture(std::span<const std::uint8_t> bytes, const std::string& path) {
  const cv::Mat image = upright_pixels(decode_image(bytes, path, PixelBits::as_stored));
  if (image.channels() != 1 || (image.depth() != CV_8U && image.depth() != CV_16U))
    throw InputError(path + ": a map of labels has one channel (grey) of 8 or 16 bits");
  cv::Mat labels;
  image.convertTo(labels, CV_32S);
  return cv::Mat(labels.size(), CV_8UC4, labels.data, labels.step).clone();
}

}  // namespace tessera
