#include "artwork/images/photo.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "artwork/images/image_decoding.h"
#include "artwork/images/reduced_picture.h"

namespace tessera {

cv::Mat photo_picture(std::span<const std::uint8_t> bytes, const std::string& path, double most_pixels) {
  cv::Mat bgra;
  cv::cvtColor(reduced_picture(decode_image(bytes, path, cv::IMREAD_COLOR), most_pixels), bgra, cv::COLOR_BGR2BGRA);
  return bgra;
}

cv::Mat label_picture(std::span<const std::uint8_t> bytes, const std::string& path) {
  const cv::Mat image = decode_image(bytes, path, cv::IMREAD_UNCHANGED);
  if (image.channels() != 1 || (image.depth() != CV_8U && image.depth() != CV_16U))
    throw InputError(path + ": a map of labels has one channel (grey) of 8 or 16 bits");
  cv::Mat labels;
  image.convertTo(labels, CV_32S);
  return cv::Mat(labels.size(), CV_8UC4, labels.data, labels.step).clone();
}

}  // namespace tessera
