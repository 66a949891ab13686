// Queries of the benchmark `scenes`, each with the silhouettes that it shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/blocking/recogniser.h"
#include "bench/blocking/silhouette_case.h"

namespace tessera::bench {

struct SceneQuery {
  ClippedQuery query;              // without curves where too little is seen
  std::vector<std::size_t> shown;  // silhouettes whose boundary is seen: the lower one first
};

/// Names of the kinds of scenes:
/// clipped: what is left of the silhouette's width, as in the benchmark `blocking`; covered: below another silhouette that is known to lie above (it has another grey); bars, branch: behind a fence, or a
/// branch, that are known, too; union: two silhouettes of one grey, one over the other; changed: a part of the outline
/// is another silhouette's.
const std::vector<std::string>& scene_kinds();

/// `hidden`: the part of the silhouette's area that is hidden, or of its outline that is replaced. `others`: silhouettes
/// that may lie over it, or give the part. The same arguments give the same query. Empty where none of the others fits.
std::optional<SceneQuery> scene_query(const SilhouetteCase& run, const std::string& kind, std::size_t silhouette,
                                      int hidden_percent, const std::vector<std::size_t>& others);

}  // namespace tessera::bench
