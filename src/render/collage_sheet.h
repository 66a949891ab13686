// ranking.png: the pictures of ranked collages, best first.
#pragma once

#include <string>
#include <vector>

#include "render/ranking.h"

namespace tessera {

/// No more than these are shown.
inline constexpr std::size_t kMaxSheetCollages = 60;

/// A PNG, for `path`. A result whose collage.png is missing or damaged leaves its place empty. `results` holds at least
/// one. Throws EnvironmentError where cairo cannot draw it.
std::vector<std::uint8_t> collage_sheet(const std::vector<RankedResult>& results, const std::string& path);

}  // namespace tessera
