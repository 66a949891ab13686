// Decides whether a query of the benchmark `scenes` was answered correctly.
#pragma once

#include "bench/blocking/success.h"

namespace tessera::bench {

/// The outcome of one query.
struct SceneSuccess {
  bool told = false;       // any shape was named
  bool itself = false;     // the first shape is the partly hidden silhouette
  bool twin = false;       // the first shape is that or a twin of it
  bool any = false;        // the first shape is any silhouette of the scene or its twin
  bool among = false;      // the hidden silhouette or a twin is among the named shapes
  bool all_among = false;  // all silhouettes of the scene, or their twins, are among the named shapes
};

/// `found`: indices in the library's list, the best first. `shown`: the silhouettes that the query shows in part, the
/// hidden one first.
SceneSuccess scene_success(const std::vector<std::uint32_t>& found, const std::vector<std::size_t>& shown,
                           const SilhouetteLibrary& library, const Twins& twins);

}  // namespace tessera::bench
