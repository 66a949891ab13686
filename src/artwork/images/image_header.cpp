#include "artwork/images/image_header.h"

#include <cmath>
#include <string_view>

#include "artwork/images/formats/byte_reader.h"

namespace tessera {
namespace {

using Side = std::optional<std::uint32_t>;

std::optional<cv::Size2d> size_of(Side width, Side height) {
  if (!width || !height) return std::nullopt;
  return cv::Size2d(*width, *height);
}

std::optional<cv::Size2d> bmp_size(const ByteReader& r) {
  if (r.integer(14, 4) == 12u) return size_of(r.integer(18, 2), r.integer(20, 2));  // OS/2
  const Side width = r.integer(18, 4), height = r.integer(22, 4);
  if (!width || !height) return std::nullopt;
  return cv::Size2d(*width, std::abs(double(std::int32_t(*height))));  // negative: stored from the top
}

/// Walks the segments to the start of a frame.
std::optional<cv::Size2d> jpeg_size(const ByteReader& r) {
  std::size_t at = 2;
  while (true) {
    while (r.integer(at, 2) == 0xffffu) ++at;  // fill bytes
    const Side marker = r.integer(at, 2), length = r.integer(at + 2, 2);
    if (!marker || !length || *marker < 0xff00) return std::nullopt;
    const std::uint32_t kind = *marker & 0xff;
    const bool is_frame = kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc;
    if (is_frame) return size_of(r.integer(at + 7, 2), r.integer(at + 5, 2));
    at += 2 + *length;
  }
}

std::optional<cv::Size2d> webp_size(const ByteReader& r) {
  if (r.has(12, "VP8X")) {
    const Side width = r.integer(24, 3), height = r.integer(27, 3);
    if (width && height) return cv::Size2d(*width + 1., *height + 1.);
  }
  if (r.has(12, "VP8L")) {
    if (const Side bits = r.integer(21, 4)) return cv::Size2d((*bits & 0x3fff) + 1., (*bits >> 14 & 0x3fff) + 1.);
  }
  if (r.has(12, "VP8 ")) {
    const Side width = r.integer(26, 2), height = r.integer(28, 2);
    if (width && height) return cv::Size2d(*width & 0x3fff, *height & 0x3fff);
  }
  return std::nullopt;
}

std::optional<cv::Size2d> tiff_size(const ByteReader& r) {
  constexpr std::uint32_t kWidthTag = 256, kHeightTag = 257, kShort = 3;
  const Side directory = r.integer(4, 4);
  if (!directory) return std::nullopt;
  const Side entries = r.integer(*directory, 2);
  Side width, height;
  for (std::size_t i = 0; entries && i < *entries; ++i) {
    const std::size_t entry = std::size_t(*directory) + 2 + 12 * i;
    const Side tag = r.integer(entry, 2);
    const int bytes = r.integer(entry + 2, 2) == kShort ? 2 : 4;
    if (tag == kWidthTag) width = r.integer(entry + 8, bytes);
    if (tag == kHeightTag) height = r.integer(entry + 8, bytes);
  }
  return size_of(width, height);
}

/// Whether an animation's chunk stands before the first pixels.
bool is_animated_png(const ByteReader& r) {
  std::size_t at = 8;
  while (const Side length = r.integer(at, 4)) {
    if (r.has(at + 4, "acTL")) return r.integer(at + 8, 4).value_or(0) > 1;
    if (r.has(at + 4, "IDAT")) return false;
    at += 12 + std::size_t(*length);
  }
  return false;
}

bool is_animated_webp(const ByteReader& r) {
  constexpr std::uint32_t kAnimated = 2;
  return r.has(12, "VP8X") && (r.integer(20, 1).value_or(0) & kAnimated) != 0;
}

/// Whether another directory comes after the first one.
bool has_several_pages(const ByteReader& r) {
  const Side directory = r.integer(4, 4);
  const Side entries = directory ? r.integer(*directory, 2) : std::nullopt;
  return entries && r.integer(std::size_t(*directory) + 2 + 12 * std::size_t(*entries), 4).value_or(0) != 0;
}

}  // namespace

ImageFormat image_format(std::span<const std::uint8_t> bytes) {
  using namespace std::string_view_literals;
  const ByteReader reader(bytes, true);
  if (reader.has(0, "\x89PNG\r\n\x1a\n"sv)) return ImageFormat::png;
  if (reader.has(0, "BM"sv)) return ImageFormat::bmp;
  if (reader.has(0, "\xff\xd8\xff"sv)) return ImageFormat::jpeg;
  if (reader.has(0, "RIFF"sv) && reader.has(8, "WEBP"sv)) return ImageFormat::webp;
  if (reader.has(0, "II*\0"sv) || reader.has(0, "MM\0*"sv)) return ImageFormat::tiff;
  return ImageFormat::none;
}

std::optional<cv::Size2d> image_size_from_header(std::span<const std::uint8_t> bytes) {
  const ByteReader big(bytes, true);
  const ByteReader little(bytes, false);
  switch (image_format(bytes)) {
    case ImageFormat::png: return size_of(big.integer(16, 4), big.integer(20, 4));
    case ImageFormat::jpeg: return jpeg_size(big);
    case ImageFormat::webp: return webp_size(little);
    case ImageFormat::tiff: return tiff_size(big.has(0, "MM") ? big : little);
    case ImageFormat::bmp: return bmp_size(little);
    case ImageFormat::none: return std::nullopt;
  }
  return std::nullopt;
}

bool has_several_pictures(std::span<const std::uint8_t> bytes) {
  const ByteReader big(bytes, true);
  const ByteReader little(bytes, false);
  switch (image_format(bytes)) {
    case ImageFormat::png: return is_animated_png(big);
    case ImageFormat::webp: return is_animated_webp(little);
    case ImageFormat::tiff: return has_several_pages(big.has(0, "MM") ? big : little);
    default: return false;
  }
}

}  // namespace tessera
