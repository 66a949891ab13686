// The orientation of the camera: EXIF data and TIFFs state it as a number from 1 (upright) to 8.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>

namespace tessera {

/// The orientation in `exif`, which starts at the byte order mark ("II" or "MM"). 1 where none is stated, or an unknown
/// one.
int exif_orientation(std::span<const std::uint8_t> exif);

/// Finds the EXIF data of a JPEG, PNG or WebP without a decoder and reads the orientation. `bytes`: the whole file.
/// Returns 1 for all other bytes, and for TIFF, whose reader reads it itself.
int orientation_in_file(std::span<const std::uint8_t> bytes);

/// `picture` mirrored and turned according to `orientation`. An upright picture is not copied.
cv::Mat turned_upright(const cv::Mat& picture, int orientation);

}  // namespace tessera
