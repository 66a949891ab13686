// Whether this machine can draw text.
#pragma once

#include <cstdint>
#include <span>

namespace tessera {

/// Without any font librsvg draws text from memory that nothing was written to: another picture each time. Asks
/// fontconfig once.
bool has_fonts();

/// Whether an SVG has text that cannot be drawn here. What looks like a text element counts, in a comment, too;
/// text in UTF-16 is not found.
bool loses_text(std::span<const std::uint8_t> svg);

}  // namespace tessera
