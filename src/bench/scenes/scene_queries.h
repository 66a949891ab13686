// Queries of the benchmark `scenes`, each with the silhouettes that it shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/blocking/recogniser.h"
#include "bench/blocking/silhouette_case.h"

namespace tessera::bench {

struct SceneQuery {
  ClippedQuery query;              // without curves where too little is visible
  std::vector<std::size_t> shown;  // silhouettes with a visible boundary, the lower one first
};

/// Names of the kinds of scenes:
/// - clipped: a part of the silhouette's width is hidden, as in the benchmark `blocking`;
/// - covered: below another silhouette that is known to be above (it has another grey);
/// - bars, branch: behind a fence or a branch, also known;
/// - union: two silhouettes of one grey, one over the other;
/// - changed: a part of the outline belongs to another silhouette.
const std::vector<std::string>& scene_kinds();

/// Makes a query. `hidden_percent`: the hidden part of the silhouette's area, or the replaced part of its outline.
/// `others`: silhouettes that may lie over it or give the new part. The same arguments give the same query. Nullopt
/// where none of the others fits.
std::optional<SceneQuery> scene_query(const SilhouetteCase& run, const std::string& kind, std::size_t silhouette,
                                      int hidden_percent, const std::vector<std::size_t>& others);

}  // namespace tessera::bench
