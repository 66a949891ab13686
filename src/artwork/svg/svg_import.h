// Prepares an untrusted SVG so that it can be part of another document, beside other SVGs.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>

namespace tessera {

/// A <g id="SCOPE_ID"> that holds the drawing as a nested <svg>, with its page at (0, 0) and of size `page_size`
/// (ArtworkPage::natural_size). It is serialised for a document whose default name space is SVG's, with the prefix
/// "xlink".
///
/// Kept are SVG's drawing elements. Dropped are scripts, event handlers, animations, foreign content, metadata, and
/// every reference except those to the document's own ids and to embedded bitmaps; parsing loads nothing either. All
/// ids and references to them get the prefix "SCOPE_ID-". Declarations of style sheets become style attributes, so that
/// no selector gets into the other document (svg_style.h). Nothing is drawn beyond the page. Blend modes affect only
/// the drawing's own parts, as when it is drawn alone.
///
/// Throws InputError where the bytes are no well-formed SVG or SVGZ, exceed libxml2's limits (entity bombs), or have a
/// style sheet or a filter that cannot be copied.
std::string import_svg(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& scope_id,
                       cv::Size2d page_size);

}  // namespace tessera
