// CSS's custom properties, which librsvg does not know: fill:var(--skin, #fc9).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace tessera {

/// The SVG with each var() of its properties replaced as a browser does it: by what the element, or the nearest outer one,
/// declares of the variable, else by what var() itself offers. A property that gets neither is inherited, or has its
/// initial value. Nothing where the unpacked SVG has no var() in its properties, or cannot be read. Throws InputError,
/// naming `path`, where it breaks a limit of svg_style.h, or needs more than a million replacements.
///
/// A browser also inherits variables from a <use> into what it shows; that is not done here.
std::optional<std::string> with_css_variables(std::span<const std::uint8_t> svg, const std::string& path);

}  // namespace tessera
