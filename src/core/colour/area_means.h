// A picture reduced, or enlarged, to a grid of cells: each cell is the mean of the pixels that it covers, by the areas
// that they share. Pixels come row by row, so that a picture need not be in memory as a whole.
#pragma once

#include <vector>

#include "core/colour/srgb.h"
#include "core/geometry/grid.h"

namespace tessera {

/// A pixel or a cell, and how much it counts: 0 to 1.
struct WeightedColour {
  Srgb colour;
  float weight = 1;
};

class AreaMeans {
 public:
  /// From a picture of so many pixels to so many cells; all numbers are 1 at least.
  AreaMeans(int picture_width, int picture_height, int cells_width, int cells_height);

  /// The next row, from the top, of as many pixels as the picture is wide.
  void add_row(const WeightedColour* pixels);

  /// The cells after the last row. Colours are means by weight, weights are means by area. Where nothing counts the
  /// colour is black and the weight 0.
  Grid<WeightedColour> cells() const;

 private:
  struct Sum {
    double red = 0, green = 0, blue = 0, weight = 0, area = 0;
  };

  void add(const Sum& part, double area, Sum& sum) const;

  const int picture_width_;
  const int picture_height_;
  int next_row_ = 0;
  std::vector<Sum> row_;  // of one row of pixels, by columns of cells
  Grid<Sum> sums_;
};

}  // namespace tessera
