// An untrusted SVG deformed with its piece's outline, made fit to stand inside another document.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/deform/warp.h"

namespace tessera {

/// A <g id="SCOPE_ID"> that holds the drawing as `page_warp` deforms it: a map of its page, (0, 0) to
/// ArtworkPage::natural_size. Serialised for a document whose default name space is SVG's, with the prefix "xlink".
///
/// It is made anew from what librsvg draws (flattened_svg.h), so that nothing of the file itself comes into it: paths,
/// clips and masks are deformed as paths, bitmaps as pixels; text has become paths; what librsvg draws as pixels, filters
/// and luminance masks, is a bitmap. Strokes keep their width; gradients and patterns
/// are moved, turned and stretched with the path that they fill. What lies
/// beyond the page is cut off along the page's deformed edge. All ids begin with "SCOPE_ID-". Throws InputError where the
/// bytes are no SVG, break a limit, or hold what can only be deformed as a picture.
std::string warped_svg(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& scope_id,
                       const Warp& page_warp);

}  // namespace tessera
