// CSS's custom properties, which librsvg does not know: fill:var(--skin, #fc9).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace tessera {

/// The SVG with all var() of its attributes and style sheets put in as a browser does it: by the declarations of "--name"
/// that count for the element or for what it stands in, else by what var() itself offers. A property without either is
/// inherited. Nothing where the SVG, which is unpacked, has no var(). Throws InputError, naming `path`, where it is not
/// well-formed, breaks a limit of svg_style.h, or has more than a million of them put in.
std::optional<std::string> with_css_variables(std::span<const std::uint8_t> svg, const std::string& path);

}  // namespace tessera
