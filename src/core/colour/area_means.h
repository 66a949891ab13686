// Reduces or enlarges a picture to a grid of cells. Each cell is the mean of the pixels that it covers, weighted by
// their common area. Pixels come row by row, so that a picture need not be in memory as a whole.
#pragma once

#include <vector>

#include "core/colour/srgb.h"
#include "core/geometry/grid.h"

namespace tessera {

/// The colour of a pixel or a cell, with its weight: 0 to 1.
struct WeightedColour {
  Srgb colour;
  float weight = 1;
};

class AreaMeans {
 public:
  /// Reduces a picture of `picture_width` x `picture_height` pixels to `cells_width` x `cells_height` cells; all
  /// numbers are at least 1.
  AreaMeans(int picture_width, int picture_height, int cells_width, int cells_height);

  /// Adds the next row from the top; it has as many pixels as the picture is wide.
  void add_row(const WeightedColour* pixels);

  /// The cells, after the last row. Colours are means by weight, weights are means by area. If no pixel of a cell has
  /// weight, its colour is black and its weight 0.
  Grid<WeightedColour> cells() const;

 private:
  struct Sum {
    double red = 0, green = 0, blue = 0, weight = 0, area = 0;
  };

  void add(const Sum& part, double area, Sum& sum) const;

  const int picture_width_;
  const int picture_height_;
  int next_row_ = 0;
  std::vector<Sum> row_;  // sums of one row of pixels, by columns of cells
  Grid<Sum> sums_;
};

}  // namespace tessera
