// PNG, WebP and TIFF with transparency; masks and pictures on a plain background without (also BMP and JPEG).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "artwork/images/artwork_page.h"

namespace tessera {

/// With Background::cut_out the background is taken out of an image without transparency (mask.h). Throws InputError
/// where it is no image that we read, is damaged, has more than kMaxImagePixels (image_decoding.h), or where a photo that
/// fills its frame was to be cut out. One of more than kMostWorkedPixels (reduced_picture.h) is drawn from a reduced copy.
std::unique_ptr<ArtworkPage> open_raster_page(std::span<const std::uint8_t> bytes, const std::string& path,
                                              Background background);

}  // namespace tessera
