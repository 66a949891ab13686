// Finds the style that a user means by the name of a drawing.
#pragma once

#include <string>
#include <vector>

#include "core/style/style_features.h"
#include "library/name_index.h"

namespace tessera {

/// Stands for the style that prevails in the library (core/style/style_groups.h), and names no drawing.
inline constexpr const char* kPrevailingStyle = "auto";

/// The mean style of the drawings whose names match the patterns `like` (name_globs.h), or kPrevailingStyle alone.
/// `places`: the styles, in the order of the names. Throws NamesNotFound where a pattern matches no name; it suggests
/// similar names.
StylePlace style_reference(const NameIndex& names, const std::vector<StylePlace>& places,
                           const std::vector<std::string>& like);

/// The message for a library that was built before styles were measured.
std::string unknown_style_text(const std::string& library, const std::string& shape);

}  // namespace tessera
