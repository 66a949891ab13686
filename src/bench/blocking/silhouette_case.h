// The data that all queries of a benchmark run share: the silhouettes, their twins, and the library to be searched.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/blocking/known_silhouettes.h"
#include "bench/blocking/recogniser.h"
#include "bench/blocking/seen_curves.h"
#include "bench/blocking/silhouette_options.h"
#include "bench/blocking/silhouettes.h"
#include "bench/blocking/twins.h"

namespace tessera::bench {

struct SilhouetteCase {
  SilhouetteOptions options;
  std::vector<Silhouette> silhouettes;
  Twins twins;
  SilhouetteLibrary library;

  /// The number of queries of each kind, and the silhouette for each of them.
  std::size_t queries() const;
  std::size_t silhouette_of(std::size_t query) const;
};

/// Reads and prepares the input that the options name. Throws InputError where it cannot be read, or gives no shape.
SilhouetteCase read_silhouette_case(const SilhouetteOptions& options);

/// The view of a query: a random rotation, and a random size of 0.7 to 1.4 where the scale is unknown and no size is
/// set.
View random_view(const SilhouetteOptions& options, Draws& draws);

/// The query with the scale and noise that the recogniser may know.
ClippedQuery told_query(std::vector<Curve> curves, const View& view, const SilhouetteOptions& options);

/// The case in a report, as JSON for programs; case_text() has a few lines for people.
nlohmann::ordered_json case_json(const SilhouetteCase& run);
std::string case_text(const SilhouetteCase& run);

}  // namespace tessera::bench
