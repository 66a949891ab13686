// Whether this machine can draw text.
#pragma once

#include <cstdint>
#include <span>

namespace tessera {

/// Whether this machine has any font; asks fontconfig once. Without a font librsvg draws text from uninitialised
/// memory: another picture each time.
bool has_fonts();

/// Whether an SVG has text that cannot be drawn here. Anything that looks like a text element counts, also in a
/// comment; text in UTF-16 is not found.
bool loses_text(std::span<const std::uint8_t> svg);

}  // namespace tessera
