// Pages from raster images: PNG, WebP and TIFF with transparency; also masks and pictures on a plain background,
// without transparency (BMP and JPEG, too).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "artwork/images/artwork_page.h"

namespace tessera {

/// Opens an image. With Background::cut_out the background of an image without transparency is removed (mask.h). Throws
/// InputError where it is no image that we read, is damaged, has more than kMaxImagePixels (image_decoding.h), or where
/// a photo that fills its frame should be cut out. An image of more than kMostWorkedPixels (reduced_picture.h) is drawn
/// from a reduced copy.
std::unique_ptr<ArtworkPage> open_raster_page(std::span<const std::uint8_t> bytes, const std::string& path,
                                              Background background);

}  // namespace tessera
