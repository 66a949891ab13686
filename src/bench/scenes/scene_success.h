// Decides whether a query of the benchmark `scenes` was answered.
#pragma once

#include "bench/blocking/success.h"

namespace tessera::bench {

/// The outcome of one query.
struct SceneSuccess {
  bool told = false;       // any shape at all
  bool itself = false;     // the first shape is the silhouette that was hidden in part
  bool twin = false;       // or a twin of it
  bool any = false;        // or anything else that the scene shows, or a twin of that
  bool among = false;      // the hidden silhouette or a twin is among the shapes told
  bool all_among = false;  // all that the scene shows is among them, each by itself or a twin
};

/// `found`: places in the library's list, the best first. `shown`: the silhouettes of which the query shows a part, the one that
/// was hidden first.
SceneSuccess scene_success(const std::vector<std::uint32_t>& found, const std::vector<std::size_t>& shown,
                           const SilhouetteLibrary& library, const Twins& twins);

}  // namespace tessera::bench
