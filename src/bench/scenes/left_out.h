// Leaves silhouettes out of the library, so that "unknown" is the right answer to their queries.
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
  classes,  // half of the classes, each completely: no similar shape is known
  shapes    // half of the shapes of each class; twins stay together
};

/// Chooses the silhouettes to leave out, with random draws from the seed. The result has true for each left-out one.
std::vector<bool> chosen_left_out(const std::vector<Silhouette>& silhouettes, const Twins& twins, LeftOut kind,
                                  std::uint64_t seed);

/// Removes their shapes, with mirror images, from the library.
void leave_out(const std::vector<bool>& left_out, SilhouetteLibrary& library);

}  // namespace tessera::bench
