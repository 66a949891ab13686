// A photograph, and the label map that says which pixel belongs to which element (tessera library extract).
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>

#include "artwork/images/image_decoding.h"

namespace tessera {

/// The picture, turned as its EXIF data say: CV_8UC4, BGRA, opaque whatever alpha the file has; 16 bits a channel
/// become 8. A picture of more than `most_pixels` is reduced (reduced_picture.h). Throws InputError as decode_image
/// does.
cv::Mat photo_picture(std::span<const std::uint8_t> bytes, const std::string& path,
                      double most_pixels = kMaxImagePixels);

/// The labels in an image of one channel with 8 or 16 bits: CV_8UC4 that holds CV_32SC1 values, so that they are sent
/// like a picture. Throws InputError, also where the image is of another kind.
cv::Mat label_picture(std::span<const std::uint8_t> bytes, const std::string& path);

}  // namespace tessera
