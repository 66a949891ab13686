// Draws ranking.png: the pictures of ranked collages, best first.
#pragma once

#include <string>
#include <vector>

#include "render/ranking.h"

namespace tessera {

/// The most collages that the sheet shows.
inline constexpr std::size_t kMaxSheetCollages = 60;

/// Makes the PNG; `path` is for messages. A result whose collage.png is missing or damaged has an empty place. `results`
/// holds at least one. Throws EnvironmentError where cairo fails.
std::vector<std::uint8_t> collage_sheet(const std::vector<RankedResult>& results, const std::string& path);

}  // namespace tessera
