// What a job wishes of colours.
#pragma once

#include <memory>
#include <vector>

#include "core/colour/colour_target.h"

namespace tessera {

/// A shape's colours in few numbers.
struct ShapeColour {
  Lab mean;
  float own_contrast = 0;  // colour_grid.h
};

struct ColourWish {
  std::shared_ptr<const ColourTarget> target;
  /// The colours of each shape of the whole library, by its number; null where nothing is wished.
  std::shared_ptr<const std::vector<ShapeColour>> of_shapes;
  float weight = 1;
  float neighbours = 0;  // a weight: above 0 neighbours are of like colours, below 0 of unlike ones

  /// Whether pieces are to show a picture.
  explicit operator bool() const { return target != nullptr && weight > 0; }
};

}  // namespace tessera
