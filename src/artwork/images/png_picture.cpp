#include "artwork/images/png_picture.h"

#include <algorithm>
#include <array>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "artwork/images/alpha.h"

namespace tessera {
namespace {

bool looks_like_png(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 8> kMark = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  return bytes.size() > kMark.size() && std::equal(kMark.begin(), kMark.end(), bytes.begin());
}

cv::Mat decoded(std::span<const std::uint8_t> bytes, const std::string& path) {
  if (!looks_like_png(bytes)) throw InputError(path + ": not a PNG file");
  // OpenCV takes a mutable pointer and only reads.
  const cv::Mat packed(1, int(bytes.size()), CV_8U, const_cast<std::uint8_t*>(bytes.data()));
  cv::Mat image;
  try {
    image = cv::imdecode(packed, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {  // sides beyond OpenCV's limits: the same as an empty image
  }
  if (image.empty() || image.depth() != CV_8U) throw InputError(path + ": a damaged image");
  return image;
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

std::vector<std::uint8_t> png_of(const cv::Mat& picture) {
  std::vector<std::uint8_t> png;
  if (!cv::imencode(".png", picture, png)) throw EnvironmentError("OpenCV cannot write a PNG");
  png.shrink_to_fit();  // a photo has thousands of cut-outs
  return png;
}

}  // namespace tessera
