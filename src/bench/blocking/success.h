// Decides whether a query of the benchmark `blocking` was recognised.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/blocking/known_silhouettes.h"
#include "bench/blocking/twins.h"

namespace tessera::bench {

/// The outcome of one query.
struct Success {
  bool told = false;    // any shape at all
  bool itself = false;  // the first shape is the silhouette
  bool twin = false;    // or a twin of it
  bool among = false;   // one of the shapes told is the silhouette
};

/// `found`: places in the library's list, the best first. `silhouette`: that the query was made from.
Success success_of(const std::vector<std::uint32_t>& found, std::size_t silhouette, const SilhouetteLibrary& library,
                   const Twins& twins);

}  // namespace tessera::bench
