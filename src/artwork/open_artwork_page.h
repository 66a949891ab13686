// Opens any untrusted artwork.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "artwork/images/artwork_page.h"

namespace tessera {

/// Opens an SVG or an image; the content decides, not the extension. `path` is used in messages. Throws InputError.
std::unique_ptr<ArtworkPage> open_artwork_page(std::span<const std::uint8_t> bytes, const std::string& path,
                                               Background background = Background::cut_out);

}  // namespace tessera
