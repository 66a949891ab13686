// The page of several results: their pictures, and a table of what was measured.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/ranking.h"
#include "report/page.h"

namespace tessera {

/// `results`: best first, at least one. `picture_bytes`: the most for all tiles, before base64. Throws EnvironmentError.
Page campaign_page(const std::string& title, const std::vector<RankedResult>& results, const RankingWeights& weights,
                   std::size_t picture_bytes);

}  // namespace tessera
