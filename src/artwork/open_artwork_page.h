// Any untrusted artwork, opened by what its bytes are.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "artwork/images/artwork_page.h"

namespace tessera {

/// Opens an SVG or an image, told apart by content, not by extension; `path` stands in messages. Throws InputError.
std::unique_ptr<ArtworkPage> open_artwork_page(std::span<const std::uint8_t> bytes, const std::string& path,
                                               Background background = Background::cut_out);

}  // namespace tessera
