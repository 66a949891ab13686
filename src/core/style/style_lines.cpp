#include "core/style/style_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tessera {
namespace {

/// Radius of the disc that closes lines, px. Lines wider than 10 px, about 4 % of the drawing's size, count as areas.
constexpr int kLineRadius_px = 5;
/// Least contrast of a line in lightness, as of light grey on white or dark brown on brown.
constexpr float kLeastContrast = 22;
/// Distance from its edge at which a line has its full contrast, px.
constexpr int kSoft_px = 2;

/// Half the width of a disc's row, at this distance from its middle row.
int reach_of_row(int dy) { return int(std::sqrt(double(kLineRadius_px * kLineRadius_px - dy * dy) + 0.5)); }

/// Makes `row_best`, the best values within `reach - 1` px on both sides, those within `reach` px.
template <class Better>
void widen(Grid<float>& row_best, const Grid<float>& values, int reach, Better better) {
  for (int y = 0; y < values.height(); ++y) {
    const float* from = values.row(y);
    float* to = row_best.row(y);
    for (int x = reach; x < values.width(); ++x) to[x] = better(to[x], from[x - reach]);
    for (int x = 0; x < values.width() - reach; ++x) to[x] = better(to[x], from[x + reach]);
  }
}

/// For each pixel the best value in a disc around it. Beyond the rim the value is `nothing`. The disc is taken row by row
/// from its short rows to its long ones, whose bests come from those of the shorter ones.
template <class Better>
Grid<float> best_in_disc(const Grid<float>& values, float nothing, Better better) {
  Grid<float> best(values.width(), values.height(), nothing);
  Grid<float> row_best = values;
  const auto take_row = [&](int dy) {
    for (int y = std::max(0, -dy); y < std::min(values.height(), values.height() - dy); ++y) {
      const float* from = row_best.row(y + dy);
      float* to = best.row(y);
      for (int x = 0; x < values.width(); ++x) to[x] = better(to[x], from[x]);
    }
  };
  int reach = 0;
  for (int dy = kLineRadius_px; dy >= 0; --dy) {
    while (reach < reach_of_row(dy)) widen(row_best, values, ++reach, better);
    take_row(dy);
    if (dy > 0) take_row(-dy);
  }
  return best;
}

float most_around(const Grid<float>& values, int x, int y) {
  float most = values(x, y);
  for (int v = std::max(0, y - kSoft_px); v <= std::min(values.height() - 1, y + kSoft_px); ++v) {
    for (int u = std::max(0, x - kSoft_px); u <= std::min(values.width() - 1, x + kSoft_px); ++u)
      most = std::max(most, values(u, v));
  }
  return most;
}

}  // namespace

Grid<float> dark_lines(const StyleRaster& raster) {
  const int width = raster.colour.width(), height = raster.colour.height();
  Grid<float> lightness(width, height);
  for (std::size_t i = 0; i < lightness.data().size(); ++i) lightness.data()[i] = raster.colour.data()[i].lightness;
  const auto larger = [](float a, float b) { return a > b ? a : b; };
  const auto smaller = [](float a, float b) { return a < b ? a : b; };
  const Grid<float> closed = best_in_disc(best_in_disc(lightness, 0, larger), 200, smaller);
  Grid<float> contrast(width, height);
  for (std::size_t i = 0; i < contrast.data().size(); ++i) {
    contrast.data()[i] = closed.data()[i] - lightness.data()[i];
  }
  Grid<float> lines(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (contrast(x, y) >= kLeastContrast) lines(x, y) = contrast(x, y) / most_around(contrast, x, y);
    }
  }
  return lines;
}

double crofton_perimeter_px(const Grid<float>& mask) {
  const auto at = [&](int x, int y) { return mask.bounds().contains(x, y) ? mask(x, y) > 0 : false; };
  long straight = 0, diagonal = 0;
  for (int y = -1; y < mask.height(); ++y) {
    for (int x = -1; x < mask.width(); ++x) {
      const bool here = at(x, y);
      straight += int(here != at(x + 1, y)) + int(here != at(x, y + 1));
      diagonal += int(here != at(x + 1, y + 1)) + int(at(x + 1, y) != at(x, y + 1));
    }
  }
  return std::numbers::pi / 8 * (double(straight) + double(diagonal) / std::numbers::sqrt2);
}

}  // namespace tessera
