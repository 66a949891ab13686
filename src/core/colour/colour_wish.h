// What a job wishes of colours.
#pragma once

#include <memory>
#include <vector>

#include "core/colour/colour_target.h"

namespace tessera {

/// Nothing where the job has no picture, or its colours have no weight.
struct ColourWish {
  std::shared_ptr<const ColourTarget> target;
  /// The mean colour of each shape of the whole library.
  std::shared_ptr<const std::vector<Lab>> of_shapes;
  float weight = 1;

  explicit operator bool() const { return target != nullptr && weight > 0; }
};

}  // namespace tessera
