// A job's wishes for colours.
#pragma once

#include <memory>
#include <vector>

#include "core/colour/colour_target.h"

namespace tessera {

/// The colours of a shape in a few numbers.
struct ShapeColour {
  Lab mean;
  float own_contrast = 0;  // see own_contrast() in colour_grid.h
};

struct ColourWish {
  std::shared_ptr<const ColourTarget> target;
  /// The colours of each shape of the whole library, by its index; null if nothing is wished.
  std::shared_ptr<const std::vector<ShapeColour>> of_shapes;
  float weight = 1;
  float neighbours = 0;  // a weight: above 0, neighbours should have similar colours; below 0, different ones

  /// Whether pieces should show a picture.
  explicit operator bool() const { return target != nullptr && weight > 0; }
};

}  // namespace tessera
