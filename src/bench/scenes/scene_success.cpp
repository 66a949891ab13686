#include "bench/scenes/scene_success.h"

#include <algorithm>

namespace tessera::bench {

SceneSuccess scene_success(const std::vector<std::uint32_t>& found, const std::vector<std::size_t>& shown,
                           const SilhouetteLibrary& library, const Twins& twins) {
  const auto shows = [&](std::uint32_t place, std::size_t silhouette) {
    const KnownSilhouette& shape = library.shapes[place];
    return twins.are_twins(silhouette, shape.silhouette, shape.mirrored);
  };
  const auto is_told = [&](std::size_t silhouette) {
    return std::any_of(found.begin(), found.end(), [&](std::uint32_t place) { return shows(place, silhouette); });
  };
  SceneSuccess success;
  if (found.empty()) return success;
  const std::uint32_t first = found.front();
  success.told = true;
  success.twin = shows(first, shown.front());
  success.itself = library.shapes[first].silhouette == shown.front() && !library.shapes[first].mirrored;
  success.any = std::any_of(shown.begin(), shown.end(), [&](std::size_t s) { return shows(first, s); });
  success.among = is_told(shown.front());
  success.all_among = std::all_of(shown.begin(), shown.end(), is_told);
  return success;
}

}  // namespace tessera::bench
