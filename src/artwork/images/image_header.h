// Reads the format and the size of an image from its header. A small file that claims a huge picture is so refused
// before its decoder asks for memory.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <span>

namespace tessera {

enum class ImageFormat { none, png, jpeg, webp, tiff, bmp };

/// The format that the first bytes tell.
ImageFormat image_format(std::span<const std::uint8_t> bytes);

/// The size of a PNG, BMP, JPEG, WebP or TIFF (its first picture). Nothing where it is none of these or too damaged to
/// tell. Never reads beyond `bytes`. Sides are as claimed: they may be 0 or huge, never negative.
std::optional<cv::Size2d> image_size_from_header(std::span<const std::uint8_t> bytes);

/// Whether an animation, or a file of several pages: readers take the first picture alone. Never reads beyond `bytes`.
bool has_several_pictures(std::span<const std::uint8_t> bytes);

}  // namespace tessera
