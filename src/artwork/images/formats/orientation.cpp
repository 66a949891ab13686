#include "artwork/images/formats/orientation.h"

#include <algorithm>
#include <string_view>

#include "artwork/images/formats/byte_reader.h"

namespace tessera {
namespace {

using namespace std::string_view_literals;
using Bytes = std::span<const std::uint8_t>;

/// The `count` bytes from `at` on; fewer where the file ends before.
Bytes part_of(Bytes bytes, std::size_t at, std::size_t count) {
  at = std::min(at, bytes.size());
  return bytes.subspan(at, std::min(count, bytes.size() - at));
}

/// The EXIF data of a JPEG: a segment before the first scan.
Bytes exif_of_jpeg(Bytes bytes) {
  constexpr std::uint32_t kExif = 0xffe1, kFirstScan = 0xffda;
  const ByteReader reader(bytes, true);
  for (std::size_t at = 2;;) {
    while (reader.integer(at, 2) == 0xffffu) ++at;  // fill bytes
    const auto marker = reader.integer(at, 2), length = reader.integer(at + 2, 2);
    if (!marker || !length || *marker < 0xff00 || *marker == kFirstScan) return {};
    if (*marker == kExif && *length > 8 && reader.has(at + 4, "Exif\0\0"sv))
      return part_of(bytes, at + 10, *length - 8);
    at += 2 + *length;
  }
}

Bytes exif_of_png(Bytes bytes) {
  const ByteReader reader(bytes, true);
  for (std::size_t at = 8;;) {
    const auto length = reader.integer(at, 4);
    if (!length) return {};
    if (reader.has(at + 4, "eXIf"sv)) return part_of(bytes, at + 8, *length);
    at += 12 + std::size_t(*length);
  }
}

/// The EXIF data of a WebP. Some programs write the mark of a JPEG's segment before them.
Bytes exif_of_webp(Bytes bytes) {
  const ByteReader reader(bytes, false);
  for (std::size_t at = 12;;) {
    const auto length = reader.integer(at + 4, 4);
    if (!length) return {};
    if (reader.has(at, "EXIF"sv)) {
      const std::size_t mark = reader.has(at + 8, "Exif\0\0"sv) ? 6 : 0;
      return part_of(bytes, at + 8 + mark, *length - std::min<std::size_t>(*length, mark));
    }
    at += 8 + std::size_t(*length) + *length % 2;
  }
}

}  // namespace

int orientation_in_file(Bytes bytes) {
  const ByteReader reader(bytes, true);
  if (reader.has(0, "\xff\xd8\xff"sv)) return exif_orientation(exif_of_jpeg(bytes));
  if (reader.has(0, "\x89PNG\r\n\x1a\n"sv)) return exif_orientation(exif_of_png(bytes));
  if (reader.has(0, "RIFF"sv) && reader.has(8, "WEBP"sv)) return exif_orientation(exif_of_webp(bytes));
  return 1;
}

int exif_orientation(std::span<const std::uint8_t> exif) {
  constexpr std::uint32_t kOrientationTag = 0x112;
  const bool big_endian = ByteReader(exif, true).has(0, "MM\0*"sv);
  const ByteReader reader(exif, big_endian);
  if (!big_endian && !reader.has(0, "II*\0"sv)) return 1;
  const std::size_t directory = reader.integer(4, 4).value_or(0);
  const std::uint32_t entries = reader.integer(directory, 2).value_or(0);
  for (std::uint32_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + 12 * std::size_t(i);
    const auto tag = reader.integer(entry, 2);
    if (!tag) break;
    if (tag != kOrientationTag) continue;
    const std::uint32_t value = reader.integer(entry + 8, 2).value_or(1);
    return value >= 1 && value <= 8 ? int(value) : 1;
  }
  return 1;
}

cv::Mat turned_upright(const cv::Mat& picture, int orientation) {
  constexpr int kTopToBottom = 0, kLeftToRight = 1, kBoth = -1;
  if (orientation <= 1) return picture;
  cv::Mat turned;
  if (orientation >= 5) cv::transpose(picture, turned);
  const cv::Mat& from = orientation >= 5 ? turned : picture;
  if (orientation == 2 || orientation == 6) cv::flip(from, turned, kLeftToRight);
  if (orientation == 3 || orientation == 7) cv::flip(from, turned, kBoth);
  if (orientation == 4 || orientation == 8) cv::flip(from, turned, kTopToBottom);
  return turned;
}

}  // namespace tessera
