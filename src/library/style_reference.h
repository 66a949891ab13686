// The style that somebody names by a drawing.
#pragma once

#include <string>
#include <vector>

#include "core/style/style_features.h"
#include "library/name_index.h"

namespace tessera {

/// Names no drawing, but the style that prevails (core/style/style_groups.h).
inline constexpr const char* kPrevailingStyle = "auto";

/// The mean style of the drawings whose names `like`, patterns (name_globs.h), are of, or kPrevailingStyle alone.
/// `places`: by name. Throws NamesNotFound where a pattern is of none, and tells names that are near it.
StylePlace style_reference(const NameIndex& names, const std::vector<StylePlace>& places,
                           const std::vector<std::string>& like);

/// What to say of a library that was built before styles were measured.
std::string unknown_style_text(const std::string& library, const std::string& shape);

}  // namespace tessera
