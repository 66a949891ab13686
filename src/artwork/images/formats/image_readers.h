// One reader for each format of pictures. Their bytes may mean harm; image_decoding.h looks which reader to take.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <stdexcept>
#include <vector>

namespace tessera {

/// How many bits the decoded pixels have in each channel.
enum class PixelBits {
  as_stored,  // 8 or 16, as in the file
  eight       // always 8
};

struct ReadingRules {
  PixelBits bits = PixelBits::as_stored;
  double most_pixels = 0;  // a picture of more is refused before memory is taken for it
};

struct DecodedImage {
  cv::Mat pixels;       // 8 or 16 bits; grey, BGR or straight BGRA
  int orientation = 1;  // orientation.h; `pixels` are not turned yet
  /// The ICC profile of the colours, which `pixels` have still; empty where the file has none: sRGB.
  std::vector<std::uint8_t> profile = {};
};

/// A picture that cannot be decoded. The message says what is wrong and leaves the path to the caller.
class UnreadableImage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The caller has checked that `bytes` begin as a file of the format does (image_header.h). Every reader throws
// UnreadableImage where the file is damaged, ends before its last pixel, breaks the rules, or is of a kind of its
// format that is not read. Of the orientation of PNG, JPEG and WebP they know nothing (orientation_in_file()).

DecodedImage read_png(std::span<const std::uint8_t> bytes, const ReadingRules& rules);
/// CMYK is taken as Adobe's programs write it: inverted; its profile is passed over.
DecodedImage read_jpeg(std::span<const std::uint8_t> bytes, const ReadingRules& rules);
/// Reads the first picture of an animation.
DecodedImage read_webp(std::span<const std::uint8_t> bytes, const ReadingRules& rules);
/// The first picture of the file, with its orientation. Tiles, strips and all compressions of libtiff; 10 to
/// 14 bits become 16.
DecodedImage read_tiff(std::span<const std::uint8_t> bytes, const ReadingRules& rules);
/// All BMPs of 1 to 32 bits a pixel, run-length encoded or not.
DecodedImage read_bmp(std::span<const std::uint8_t> bytes, const ReadingRules& rules);

// The readers of all formats share the following.

[[noreturn]] void throw_damaged();
[[noreturn]] void throw_ends_early();

/// Throws UnreadableImage where a side is 0 or too long, or where pixels are too many.
void check_size(double width_px, double height_px, const ReadingRules& rules);

/// An image of this size whose pixels are still to be filled in. Throws as check_size, before it takes memory.
cv::Mat room_for_pixels(double width_px, double height_px, int type, const ReadingRules& rules);

}  // namespace tessera
