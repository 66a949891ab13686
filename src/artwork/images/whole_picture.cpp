#include "artwork/images/whole_picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "artwork/images/image_decoding.h"
#include "artwork/images/photo.h"
#include "artwork/images/reduced_picture.h"
#include "core/base/error.h"

namespace tessera {

cv::Mat whole_picture(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px) {
  DecodedImage image = decode_image(bytes, path, PixelBits::as_stored);
  cv::Mat& picture = image.pixels;
  if (std::max(picture.cols, picture.rows) > longest_side_px) {
    throw InputError(cv::format("%s: %d x %d pixels, allowed: %d px each way", path.c_str(), picture.cols, picture.rows,
                                longest_side_px));
  }
  if (picture.channels() != 4) {
    picture.release();
    return photo_picture(bytes, path, kMostWorkedPixels);
  }
  picture = reduced_picture(picture, kMostWorkedPixels);  // before turning, which needs its memory a second time
  return seen_pixels(std::move(image));
}

}  // namespace tessera
