#include "artwork/images/image_decoding.h"

#include <stdexcept>

#include "artwork/images/colour_profile.h"
#include "artwork/images/formats/orientation.h"
#include "artwork/images/image_header.h"
#include "artwork/images/looks_like_svg.h"
#include "artwork/images/unread_format.h"
#include "core/base/error.h"

namespace tessera {
namespace {

/// Throws an error that says what the file is, if its first bytes show it, where it has none of the formats.
[[noreturn]] void refuse_format(std::span<const std::uint8_t> bytes) {
  if (looks_like_svg(bytes)) {
    throw UnreadableImage(
        "found an SVG, needed: a picture of pixels; rsvg-convert -w 2000 FILE.svg -o FILE.png draws one");
  }
  const std::string unread = unread_format(bytes);
  if (!unread.empty()) throw UnreadableImage(unread_format_reason(unread));
  throw UnreadableImage("neither SVG nor a readable PNG, WebP, TIFF, BMP or JPEG image");
}

DecodedImage decoded(std::span<const std::uint8_t> bytes, const ReadingRules& rules) {
  // This comes before a decoder: a small file may claim a huge picture.
  if (const auto size = image_size_from_header(bytes)) check_size(size->width, size->height, rules);
  switch (image_format(bytes)) {
    case ImageFormat::png: return read_png(bytes, rules);
    case ImageFormat::jpeg: return read_jpeg(bytes, rules);
    case ImageFormat::webp: return read_webp(bytes, rules);
    case ImageFormat::tiff: return read_tiff(bytes, rules);
    case ImageFormat::bmp: return read_bmp(bytes, rules);
    case ImageFormat::none: refuse_format(bytes);
  }
  throw std::logic_error("no such format");
}

}  // namespace

DecodedImage decode_image(std::span<const std::uint8_t> bytes, const std::string& path, PixelBits bits) {
  try {
    DecodedImage image = decoded(bytes, {.bits = bits, .most_pixels = kMaxImagePixels});
    if (image_format(bytes) != ImageFormat::tiff) image.orientation = orientation_in_file(bytes);
    return image;
  } catch (const UnreadableImage& error) {
    throw InputError(path + ": " + error.what());
  }
}

cv::Mat upright_pixels(const DecodedImage& image) { return turned_upright(image.pixels, image.orientation); }

cv::Mat seen_pixels(DecodedImage image) {
  make_srgb(image.pixels, image.profile);
  return upright_pixels(image);
}

}  // namespace tessera
