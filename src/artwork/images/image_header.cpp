#include "artwork/images/image_header.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tessera {
namespace {

/// Integers at any place; beyond the end they are missing.
class Reader {
 public:
  Reader(std::span<const std::uint8_t> bytes, bool big_endian) : bytes_(bytes), big_endian_(big_endian) {}

  std::size_t size() const { return bytes_.size(); }

  bool has(std::size_t at, std::string_view text) const {
    return at <= bytes_.size() && text.size() <= bytes_.size() - at &&
           std::equal(text.begin(), text.end(), bytes_.begin() + std::ptrdiff_t(at),
                      [](char c, std::uint8_t b) { return std::uint8_t(c) == b; });
  }

  std::optional<std::uint32_t> integer(std::size_t at, int width) const {
    if (at > bytes_.size() || std::size_t(width) > bytes_.size() - at) return std::nullopt;
    std::uint32_t value = 0;
    for (int i = 0; i < width; ++i) value = value << 8 | bytes_[at + std::size_t(big_endian_ ? i : width - 1 - i)];
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  bool big_endian_;
};

using Side = std::optional<std::uint32_t>;

std::optional<cv::Size2d> size_of(Side width, Side height) {
  if (!width || !height) return std::nullopt;
  return cv::Size2d(*width, *height);
}

std::optional<cv::Size2d> bmp_size(const Reader& r) {
  if (r.integer(14, 4) == 12u) return size_of(r.integer(18, 2), r.integer(20, 2));  // OS/2
  const Side width = r.integer(18, 4), height = r.integer(22, 4);
  if (!width || !height) return std::nullopt;
  return cv::Size2d(*width, std::abs(double(std::int32_t(*height))));  // negative: stored from the top
}

/// Walks the segments to the start of a frame.
std::optional<cv::Size2d> jpeg_size(const Reader& r) {
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

std::optional<cv::Size2d> webp_size(const Reader& r) {
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

std::optional<cv::Size2d> tiff_size(const Reader& r) {
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

}  // namespace

std::optional<cv::Size2d> image_size_from_header(std::span<const std::uint8_t> bytes) {
  using namespace std::string_view_literals;
  const Reader big(bytes, true);
  const Reader little(bytes, false);
  if (big.has(0, "\x89PNG\r\n\x1a\n"sv)) return size_of(big.integer(16, 4), big.integer(20, 4));
  if (big.has(0, "BM"sv)) return bmp_size(little);
  if (big.has(0, "\xff\xd8\xff"sv)) return jpeg_size(big);
  if (big.has(0, "RIFF"sv) && big.has(8, "WEBP"sv)) return webp_size(little);
  if (big.has(0, "II*\0"sv)) return tiff_size(little);
  if (big.has(0, "MM\0*"sv)) return tiff_size(big);
  return std::nullopt;
}

}  // namespace tessera
