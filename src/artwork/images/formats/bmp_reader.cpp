#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "artwork/images/formats/byte_reader.h"
#include "artwork/images/formats/image_readers.h"

namespace tessera {
namespace {

constexpr std::size_t kFileHeader_bytes = 14;
constexpr std::uint32_t kOldHeader_bytes = 12;  // the header of OS/2
constexpr std::uint32_t kHeader_bytes = 40;     // every other header has as many or more
enum Compression : std::uint32_t { kNone = 0, kRle8 = 1, kRle4 = 2, kMasks = 3 };

using Masks = std::array<std::uint32_t, 4>;  // the bits of blue, green, red and alpha in a pixel

struct Header {
  std::uint32_t bytes = 0;  // length of this header, which follows the header of the file
  std::size_t pixels_at = 0;
  int width_px = 0, height_px = 0;
  bool from_top = false;
  std::uint32_t bits = 0;  // bits of a pixel
  std::uint32_t compression = kNone;
  std::uint32_t colours = 0;  // number of colours in the palette

  bool is_encoded() const { return compression == kRle8 || compression == kRle4; }
  std::size_t row_bytes() const { return (std::size_t(width_px) * bits + 7) / 8; }
  std::size_t stride_bytes() const { return (row_bytes() + 3) / 4 * 4; }
  /// The row of the picture that the file stores as its row number `i`: files begin with the lowest row or the highest.
  int row(int i) const { return from_top ? i : height_px - 1 - i; }
};

class BmpReader {
 public:
  BmpReader(std::span<const std::uint8_t> bytes, const ReadingRules& rules)
      : bytes_(bytes),
        reader_(bytes, false),
        rules_(rules),
        header_(read_header()) {}

  cv::Mat read() {
    check_kind();
    if (header_.bits > 8) return direct_colours();
    read_palette();
    cv::Mat indices = room(CV_8UC1);  // into the palette
    header_.is_encoded() ? decode_runs(indices) : unpack_indices(indices);
    return palette_is_grey() ? greys_of(indices) : colours_of(indices);
  }

 private:
  std::uint32_t number(std::size_t at, int bytes) const {
    const auto value = reader_.integer(at, bytes);
    if (!value) throw_ends_early();
    return *value;
  }

  Header read_header() const {
    Header header;
    header.pixels_at = number(10, 4);
    header.bytes = number(kFileHeader_bytes, 4);
    if (header.bytes == kOldHeader_bytes) {
      header.width_px = int(number(18, 2));
      header.height_px = int(number(20, 2));
      header.bits = number(24, 2);
      header.colours = 1u << std::min(header.bits, 8u);
      return header;
    }
    if (header.bytes < kHeader_bytes || header.bytes > bytes_.size()) throw_damaged();
    const auto height = std::int32_t(number(22, 4));
    header.width_px = std::int32_t(number(18, 4));
    header.from_top = height < 0;
    header.height_px = int(std::abs(std::max(height, -INT32_MAX)));
    header.bits = number(28, 2);
    header.compression = number(30, 4);
    const std::uint32_t colours = number(46, 4);
    header.colours = colours > 0 ? colours : 1u << std::min(header.bits, 8u);
    return header;
  }

  void check_kind() const {
    const std::uint32_t bits = header_.bits, compression = header_.compression;
    const bool plain = bits == 1 || bits == 4 || bits == 8 || bits == 16 || bits == 24 || bits == 32;
    const bool known = (plain && compression == kNone) || (bits == 8 && compression == kRle8) ||
                       (bits == 4 && compression == kRle4) || ((bits == 16 || bits == 32) && compression == kMasks);
    if (!known) throw UnreadableImage("a BMP of a kind that is not read; convert it to PNG");
  }

  cv::Mat room(int type) const {
    cv::Mat pixels = room_for_pixels(header_.width_px, header_.height_px, type, rules_);
    const std::size_t needed = header_.stride_bytes() * std::size_t(header_.height_px - 1) + header_.row_bytes();
    const bool all_there = header_.pixels_at <= bytes_.size() && needed <= bytes_.size() - header_.pixels_at;
    if (!header_.is_encoded() && !all_there) throw_ends_early();
    return pixels;
  }

  /// The bytes of the row that the file stores as number `i`. room() has checked that the file holds all rows.
  const std::uint8_t* stored_row(int i) const {
    return bytes_.data() + header_.pixels_at + header_.stride_bytes() * std::size_t(i);
  }

  void read_palette() {
    const int entry_bytes = header_.bytes == kOldHeader_bytes ? 3 : 4;
    if (header_.colours > palette_.size()) throw_damaged();
    for (std::uint32_t i = 0; i < header_.colours; ++i) {
      const std::size_t at = kFileHeader_bytes + header_.bytes + std::size_t(entry_bytes) * i;
      for (int c = 0; c < 3; ++c) palette_[i][c] = std::uint8_t(number(at + std::size_t(c), 1));
    }
  }

  bool palette_is_grey() const {
    return std::all_of(palette_.begin(), palette_.begin() + (1 << header_.bits),
                       [](const cv::Vec3b& c) { return c[0] == c[1] && c[1] == c[2]; });
  }

  cv::Mat greys_of(cv::Mat& indices) const {
    for (std::uint8_t& pixel : cv::Mat_<std::uint8_t>(indices)) pixel = palette_[pixel][0];
    return indices;
  }

  cv::Mat colours_of(const cv::Mat& indices) const {
    cv::Mat colours(indices.size(), CV_8UC3);
    for (int y = 0; y < indices.rows; ++y) {
      for (int x = 0; x < indices.cols; ++x) colours.at<cv::Vec3b>(y, x) = palette_[indices.at<std::uint8_t>(y, x)];
    }
    return colours;
  }

  void unpack_indices(cv::Mat& indices) const {
    const int bits = int(header_.bits);
    for (int i = 0; i < indices.rows; ++i) {
      const std::uint8_t* from = stored_row(i);
      std::uint8_t* to = indices.ptr(header_.row(i));
      for (int x = 0; x < indices.cols; ++x) {
        const int bit = x * bits;
        to[x] = std::uint8_t(from[bit / 8] >> (8 - bits - bit % 8) & ((1 << bits) - 1));
      }
    }
  }

  /// Fills `indices` from run-length encoded rows. Pixels that the runs skip get index 0, the first colour of the
  /// palette.
  void decode_runs(cv::Mat& indices) const {
    constexpr std::uint32_t kEndOfRow = 0, kEndOfPicture = 1, kSkip = 2;
    const bool nibbles = header_.compression == kRle4;
    indices = 0;
    std::size_t at = header_.pixels_at;
    int x = 0, y = 0;
    const auto put = [&](std::uint32_t value) {
      if (x >= indices.cols) throw_damaged();
      indices.at<std::uint8_t>(header_.row(y), x++) = std::uint8_t(value);
    };
    const auto nibble = [](std::uint32_t byte, std::uint32_t i) { return i % 2 == 0 ? byte >> 4 : byte & 15; };
    while (y < indices.rows && !(y == indices.rows - 1 && x == indices.cols)) {
      const std::uint32_t count = number(at, 1), code = number(at + 1, 1);
      at += 2;
      if (count > 0) {
        for (std::uint32_t i = 0; i < count; ++i) put(nibbles ? nibble(code, i) : code);
      } else if (code == kEndOfPicture) {
        return;
      } else if (code == kEndOfRow) {
        x = 0;
        ++y;
      } else if (code == kSkip) {
        x += int(number(at, 1));
        y += int(number(at + 1, 1));
        at += 2;
        if (x > indices.cols) throw_damaged();
      } else {
        for (std::uint32_t i = 0; i < code; ++i) put(nibbles ? nibble(number(at + i / 2, 1), i) : number(at + i, 1));
        const std::uint32_t stored_bytes = nibbles ? (code + 1) / 2 : code;
        at += (stored_bytes + 1) / 2 * 2;
      }
    }
  }

  cv::Mat direct_colours() const {
    const bool has_masks = header_.bits != 24;
    const Masks masks = has_masks ? channel_masks() : Masks{};
    const int channels = masks[3] != 0 ? 4 : 3;
    cv::Mat pixels = room(CV_8UC(channels));
    for (int i = 0; i < pixels.rows; ++i) {
      const std::uint8_t* from = stored_row(i);
      std::uint8_t* to = pixels.ptr(header_.row(i));
      has_masks ? take_apart(from, masks, channels, to) : void(std::copy_n(from, header_.row_bytes(), to));
    }
    return pixels;
  }

  Masks channel_masks() const {
    if (header_.compression == kNone && header_.bits == 16) return {0x1f, 0x3e0, 0x7c00, 0};
    if (header_.compression == kNone) return {0xff, 0xff00, 0xff0000, 0};
    constexpr std::size_t kMasksAt = kFileHeader_bytes + kHeader_bytes;  // within the header or behind it
    constexpr std::uint32_t kHeaderWithAlpha_bytes = 56;
    const bool with_alpha = header_.bytes >= kHeaderWithAlpha_bytes;
    return {number(kMasksAt + 8, 4), number(kMasksAt + 4, 4), number(kMasksAt, 4),
            with_alpha ? number(kMasksAt + 12, 4) : 0};
  }

  /// The value of one channel as 8 bits. A mask of more bits loses its lowest, a mask of fewer leaves the lowest 0.
  static std::uint8_t channel(std::uint32_t pixel, std::uint32_t mask) {
    const int shift = std::bit_width(mask) - 8;
    return std::uint8_t(shift >= 0 ? (pixel & mask) >> shift : (pixel & mask) << -shift);
  }

  void take_apart(const std::uint8_t* from, const Masks& masks, int channels, std::uint8_t* to) const {
    const std::size_t pixel_bytes = header_.bits / 8;
    for (int x = 0; x < header_.width_px; ++x, from += pixel_bytes) {
      std::uint32_t pixel = 0;
      for (std::size_t i = 0; i < pixel_bytes; ++i) pixel |= std::uint32_t(from[i]) << 8 * i;
      for (int c = 0; c < channels; ++c) *to++ = channel(pixel, masks[std::size_t(c)]);
    }
  }

  std::span<const std::uint8_t> bytes_;
  ByteReader reader_;
  ReadingRules rules_;
  Header header_;
  std::array<cv::Vec3b, 256> palette_{};
};

}  // namespace

DecodedImage read_bmp(std::span<const std::uint8_t> bytes, const ReadingRules& rules) {
  return {.pixels = BmpReader(bytes, rules).read()};
}

}  // namespace tessera
