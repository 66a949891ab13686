// Decides whether a query of the benchmark `blocking` was recognised.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/blocking/known_silhouettes.h"
#include "bench/blocking/twins.h"

namespace tessera::bench {

/// The outcome of one query.
struct Success {
  bool told = false;    // any shape was named
  bool itself = false;  // the first shape is the silhouette
  bool twin = false;    // the first shape is the silhouette or a twin of it
  bool among = false;   // one of the named shapes is the silhouette
};

/// `found`: indices in the library's list, the best first. `silhouette`: the one from which the query was made.
Success success_of(const std::vector<std::uint32_t>& found, std::size_t silhouette, const SilhouetteLibrary& library,
                   const Twins& twins);

}  // namespace tessera::bench
