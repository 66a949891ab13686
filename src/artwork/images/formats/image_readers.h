// One reader for each picture format. The bytes are untrusted; image_decoding.h chooses the reader.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <stdexcept>
#include <vector>

namespace tessera {

/// The number of bits of the decoded pixels in each channel.
enum class PixelBits {
  as_stored,  // 8 or 16, as in the file
  eight       // always 8
};

struct ReadingRules {
  PixelBits bits = PixelBits::as_stored;
  double most_pixels = 0;  // a larger picture is refused before memory is allocated for it
};

struct DecodedImage {
  cv::Mat pixels;       // 8 or 16 bits; grey, BGR or straight BGRA
  int orientation = 1;  // orientation.h; `pixels` are not turned yet
  /// The ICC profile that `pixels` are still in; empty where the file has none: sRGB.
  std::vector<std::uint8_t> profile = {};
};

/// A picture that cannot be decoded. The message says what is wrong and leaves the path to the caller.
class UnreadableImage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The caller has checked that `bytes` begin like a file of the format (image_header.h). Every reader throws
// UnreadableImage where the file is damaged, ends before its last pixel, breaks the rules, or is of an unsupported kind
// of its format. Readers of PNG, JPEG and WebP ignore the orientation (orientation_in_file()).

DecodedImage read_png(std::span<const std::uint8_t> bytes, const ReadingRules& rules);
/// CMYK is taken as inverted, as Adobe's programs write it; its profile is ignored.
DecodedImage read_jpeg(std::span<const std::uint8_t> bytes, const ReadingRules& rules);
/// Reads the first picture of an animation.
DecodedImage read_webp(std::span<const std::uint8_t> bytes, const ReadingRules& rules);
/// Reads the first picture of the file with its orientation. Supports tiles, strips and all compressions of libtiff; 10
/// to 14 bits become 16.
DecodedImage read_tiff(std::span<const std::uint8_t> bytes, const ReadingRules& rules);
/// All BMPs of 1 to 32 bits a pixel, run-length encoded or not.
DecodedImage read_bmp(std::span<const std::uint8_t> bytes, const ReadingRules& rules);

// The functions below are shared by the readers of all formats.

[[noreturn]] void throw_damaged();
[[noreturn]] void throw_ends_early();

/// Throws UnreadableImage where a side is 0 or too long, or there are too many pixels.
void check_size(double width_px, double height_px, const ReadingRules& rules);

/// An image of this size whose pixels are not set yet. Throws like check_size, before it allocates memory.
cv::Mat room_for_pixels(double width_px, double height_px, int type, const ReadingRules& rules);

}  // namespace tessera
