// Reads the format and the size of an image from its header. So a small file that claims a huge picture is refused
// before its decoder allocates memory.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <span>

namespace tessera {

enum class ImageFormat { none, png, jpeg, webp, tiff, bmp };

/// The format, recognised by the first bytes.
ImageFormat image_format(std::span<const std::uint8_t> bytes);

/// The size of a PNG, BMP, JPEG, WebP or TIFF (its first picture). Nullopt where the file is none of these or too
/// damaged. Never reads beyond `bytes`. Sides are as the file claims: they may be 0 or huge, never negative.
std::optional<cv::Size2d> image_size_from_header(std::span<const std::uint8_t> bytes);

/// Whether the file is an animation or has several pages: readers take only the first picture. Never reads beyond
/// `bytes`.
bool has_several_pictures(std::span<const std::uint8_t> bytes);

}  // namespace tessera
