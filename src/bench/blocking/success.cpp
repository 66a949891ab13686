#include "bench/blocking/success.h"

#include <algorithm>

namespace tessera::bench {

Success success_of(const std::vector<std::uint32_t>& found, std::size_t silhouette, const SilhouetteLibrary& library,
                   const Twins& twins) {
  const auto is_itself = [&](std::uint32_t place) {
    return library.shapes[place].silhouette == silhouette && !library.shapes[place].mirrored;
  };
  Success success;
  if (found.empty()) return success;
  const KnownSilhouette& first = library.shapes[found.front()];
  success.told = true;
  success.itself = is_itself(found.front());
  success.twin = twins.are_twins(silhouette, first.silhouette, first.mirrored);
  success.among = std::any_of(found.begin(), found.end(), is_itself);
  return success;
}

}  // namespace tessera::bench
