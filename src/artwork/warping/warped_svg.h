// Deforms an untrusted SVG together with its piece's outline, so that it can be part of another document.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/deform/warp.h"

namespace tessera {

/// A <g id="SCOPE_ID"> that holds the drawing deformed by `page_warp`, a map of its page, (0, 0) to
/// ArtworkPage::natural_size. It is serialised for a document whose default name space is SVG's, with the prefix
/// "xlink".
///
/// It is made from what librsvg draws (flattened_svg.h), so nothing of the file itself is copied. Paths, clips and
/// masks are deformed as paths, bitmaps as pixels. Text has become paths; filters and luminance masks, which librsvg
/// draws as pixels, have become bitmaps. Strokes keep their width. Gradients and patterns are moved, turned and
/// stretched with the path that they fill. Parts beyond the page are cut off along the page's deformed edge. All ids
/// begin with "SCOPE_ID-".
///
/// Throws InputError where the bytes are no SVG, exceed a limit, or hold something that can only be deformed as a
/// picture.
std::string warped_svg(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& scope_id,
                       const Warp& page_warp);

}  // namespace tessera
