// Resolves CSS's custom properties, which librsvg does not know: fill:var(--skin, #fc9).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace tessera {

/// The SVG with each var() in its properties replaced as a browser does. A var() gets the declaration of the variable
/// in the element or the nearest outer one, else the fallback in var() itself. A property without either is inherited
/// or gets its initial value. Nullopt where the unpacked SVG has no var() in its properties, or cannot be read. Throws
/// InputError, which names `path`, where it exceeds a limit of svg_style.h, or needs more than a million replacements.
///
/// Different from a browser: variables are not inherited from a <use> into the element that it shows.
std::optional<std::string> with_css_variables(std::span<const std::uint8_t> svg, const std::string& path);

}  // namespace tessera
