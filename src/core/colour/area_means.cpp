#include "core/colour/area_means.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

/// Calls `take(cell, length)` for each of `cells` cells that overlaps pixel `at` of `pixels`. `length` is the length of
/// the overlap, in cells. It is computed in whole numbers, so that rounding never moves a pixel into the next cell.
template <class Take>
void for_each_part(int at, int pixels, int cells, Take take) {
  // Ends of the pixel and of the cells, in units in which a pixel is `cells` long and a cell `pixels`.
  const long long begin = static_cast<long long>(at) * cells, end = begin + cells;
  for (long long cell = begin / pixels; cell * pixels < end; ++cell) {
    const long long from = std::max(begin, cell * pixels), to = std::min(end, (cell + 1) * pixels);
    take(int(cell), double(to - from) / pixels);
  }
}

}  // namespace

AreaMeans::AreaMeans(int picture_width, int picture_height, int cells_width, int cells_height)
    : picture_width_(picture_width),
      picture_height_(picture_height),
      row_(std::size_t(cells_width)),
      sums_(cells_width, cells_height) {}

void AreaMeans::add(const Sum& part, double area, Sum& sum) const {
  sum.red += area * part.red;
  sum.green += area * part.green;
  sum.blue += area * part.blue;
  sum.weight += area * part.weight;
  sum.area += area * part.area;
}

void AreaMeans::add_row(const WeightedColour* pixels) {
  std::fill(row_.begin(), row_.end(), Sum{});
  for (int x = 0; x < picture_width_; ++x) {
    const auto& [colour, weight] = pixels[x];
    const double w = double(weight);
    const Sum pixel{w * double(colour.red), w * double(colour.green), w * double(colour.blue), w, 1};
    for_each_part(x, picture_width_, sums_.width(),
                  [&](int cell, double length) { add(pixel, length, row_[std::size_t(cell)]); });
  }
  for_each_part(next_row_++, picture_height_, sums_.height(), [&](int cell, double length) {
    Sum* sums = sums_.row(cell);
    for (std::size_t x = 0; x < row_.size(); ++x) add(row_[x], length, sums[x]);
  });
}

Grid<WeightedColour> AreaMeans::cells() const {
  Grid<WeightedColour> cells(sums_.width(), sums_.height(), {{}, 0});
  for (std::size_t i = 0; i < sums_.data().size(); ++i) {
    const Sum& sum = sums_.data()[i];
    if (!(sum.weight > 0)) continue;
    cells.data()[i] = {{float(sum.red / sum.weight), float(sum.green / sum.weight), float(sum.blue / sum.weight)},
                       float(sum.weight / sum.area)};
  }
  return cells;
}

}  // namespace tessera
