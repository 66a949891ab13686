#include "artwork/images/image_decoding.h"

#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "artwork/images/looks_like_svg.h"
#include "core/base/error.h"
#include "artwork/images/image_header.h"
#include "artwork/images/unread_format.h"

namespace tessera {
namespace {

void check_header(std::span<const std::uint8_t> bytes, const std::string& path) {
  const std::optional<cv::Size2d> size = image_size_from_header(bytes);
  const std::string unread = unread_format(bytes);
  if (looks_like_svg(bytes)) {
    throw InputError(path + ": found an SVG, needed: a picture of pixels; rsvg-convert -w 2000 FILE.svg -o FILE.png " +
                     "draws one");
  }
  if (!unread.empty()) throw InputError(path + ": " + unread_format_reason(unread));
  if (!size) throw InputError(path + ": neither SVG nor a readable PNG, WebP, TIFF, BMP or JPEG image");
  if (size->area() > kMaxImagePixels) {
    throw InputError(cv::format("%s: %.0f x %.0f pixels, more than the %.0f million allowed", path.c_str(), size->width,
                                size->height, kMaxImagePixels * 1e-6));
  }
}

}  // namespace

cv::Mat decode_image(std::span<const std::uint8_t> bytes, const std::string& path, int flags) {
  check_header(bytes, path);
  // OpenCV takes a mutable pointer and only reads.
  const cv::Mat packed(1, int(bytes.size()), CV_8U, const_cast<std::uint8_t*>(bytes.data()));
  cv::Mat image;
  try {
    image = cv::imdecode(packed, flags);
  } catch (const cv::Exception&) {  // the same as an empty image
  }
  if (image.empty()) throw InputError(path + ": a damaged image");
  return image;
}

}  // namespace tessera
