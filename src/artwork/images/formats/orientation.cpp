#include "artwork/images/formats/orientation.h"

#include <string_view>

#include "artwork/images/formats/byte_reader.h"

namespace tessera {

int exif_orientation(std::span<const std::uint8_t> exif) {
  constexpr std::uint32_t kOrientationTag = 0x112;
  using namespace std::string_view_literals;
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
