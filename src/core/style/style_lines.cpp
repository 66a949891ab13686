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

/// For each pixel the best value in a disc around it. Beyond the rim the value is `nothing`.
template <class Better>
Grid<float> best_in_disc(const Grid<float>& values, float nothing, Better better) {
  Grid<float> best(values.width(), values.height(), nothing);
  for (int dy = -kLineRadius_px; dy <= kLineRadius_px; ++dy) {
    const int reach = int(std::sqrt(double(kLineRadius_px * kLineRadius_px - dy * dy) + 0.5));
    for (int y = std::max(0, -dy); y < std::min(values.height(), values.height() - dy); ++y) {
      const float* from = values.row(y + dy);
      float* to = best.row(y);
      for (int dx = -reach; dx <= reach; ++dx) {
        const int end = std::min(values.width(), values.width() - dx);
        for (int x = std::max(0, -dx); x < end; ++x) to[x] = better(to[x], from[x + dx]);
      }
    }
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
