// Silhouettes that are kept out of the library, so that "nothing that the library has" is the right answer to a query.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/blocking/known_silhouettes.h"
#include "bench/blocking/silhouettes.h"
#include "bench/blocking/twins.h"

namespace tessera::bench {

enum class LeftOut {
  none,
  classes,  // half of the classes, each as a whole: nothing of its kind is known
  shapes    // half of the shapes of each class; twins share their lot
};

/// Chooses the silhouettes that are left out, by draws of the seed. One value a silhouette: true where it is left out.
std::vector<bool> chosen_left_out(const std::vector<Silhouette>& silhouettes, const Twins& twins, LeftOut kind,
                                  std::uint64_t seed);

/// Removes their shapes, mirror images too, from the library.
void leave_out(const std::vector<bool>& left_out, SilhouetteLibrary& library);

}  // namespace tessera::bench
