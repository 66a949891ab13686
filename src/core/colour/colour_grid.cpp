#include "core/colour/colour_grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tessera {
namespace {

struct Sum {
  double lightness = 0, a = 0, b = 0, alpha = 0, pixels = 0;
};

std::uint8_t byte_of(double value) { return std::uint8_t(std::clamp(std::lround(value), 0l, 255l)); }

int cell_along(float at_px, float low_px, float high_px) {
  return std::clamp(int(std::floor((at_px - low_px) / (high_px - low_px) * kColourSide)), -1, kColourSide);
}

}  // namespace

bool ColourGrid::known() const {
  for (std::size_t cell = 0; cell < kColourCells; ++cell) {
    if (bytes[4 * cell + 3] > 0) return true;
  }
  return false;
}

ColourGrid make_colour_grid(const ColourRaster& raster, Vec2 low_px, Vec2 high_px) {
  std::array<Sum, kColourCells> sums{};
  for (int y = 0; y < raster.colour.height(); ++y) {
    const int row = cell_along(raster.origin_px.y + (float(y) + 0.5f) * raster.pixel_px.y, low_px.y, high_px.y);
    if (row < 0 || row == kColourSide) continue;
    for (int x = 0; x < raster.colour.width(); ++x) {
      const int column = cell_along(raster.origin_px.x + (float(x) + 0.5f) * raster.pixel_px.x, low_px.x, high_px.x);
      if (column < 0 || column == kColourSide) continue;
      Sum& sum = sums[std::size_t(row * kColourSide + column)];
      const double alpha = raster.alpha(x, y);
      const Lab& lab = raster.colour(x, y);
      sum.lightness += alpha * lab.lightness;
      sum.a += alpha * lab.a;
      sum.b += alpha * lab.b;
      sum.alpha += alpha;
      sum.pixels += 1;
    }
  }
  ColourGrid grid;
  for (std::size_t cell = 0; cell < kColourCells; ++cell) {
    const Sum& sum = sums[cell];
    std::uint8_t* bytes = grid.bytes.data() + 4 * cell;
    if (sum.alpha <= 0) continue;
    bytes[0] = byte_of(sum.lightness / sum.alpha * 2.55);
    bytes[1] = byte_of(sum.a / sum.alpha + 128);
    bytes[2] = byte_of(sum.b / sum.alpha + 128);
    bytes[3] = byte_of(sum.alpha / sum.pixels * 255);
  }
  return grid;
}

ColourGrid mirrored(const ColourGrid& grid) {
  ColourGrid result;
  for (int row = 0; row < kColourSide; ++row) {
    for (int column = 0; column < kColourSide; ++column) {
      std::copy_n(grid.bytes.begin() + 4 * (row * kColourSide + column), 4,
                  result.bytes.begin() + 4 * (row * kColourSide + kColourSide - 1 - column));
    }
  }
  return result;
}

float own_contrast(const ColourGrid& grid) {
  const ColourModel model = make_colour_model(grid, {0, 0}, {1, 1});
  const auto square = [](float difference) { return difference * difference; };
  float sum = 0;
  for (std::size_t cell = 0; cell < kColourCells; ++cell) {
    const Lab& colour = model.colour[cell];
    sum += model.part[cell] * (square(colour.lightness - model.mean.lightness) +
                               square(0.5f * (colour.a - model.mean.a)) + square(0.5f * (colour.b - model.mean.b)));
  }
  return std::sqrt(sum);
}

ColourModel make_colour_model(const ColourGrid& grid, Vec2 low, Vec2 high) {
  ColourModel model;
  const Vec2 side = (high - low) * (1.f / kColourSide);
  model.cell = std::sqrt(side.x * side.y);
  float drawn = 0;
  for (std::size_t cell = 0; cell < kColourCells; ++cell) drawn += float(grid.bytes[4 * cell + 3]);
  for (std::size_t cell = 0; cell < kColourCells; ++cell) {
    const std::uint8_t* bytes = grid.bytes.data() + 4 * cell;
    model.at[cell] = {low.x + side.x * (float(cell % kColourSide) + 0.5f),
                      low.y + side.y * (float(cell / kColourSide) + 0.5f)};
    model.colour[cell] = {float(bytes[0]) / 2.55f, float(bytes[1]) - 128, float(bytes[2]) - 128};
    const float part = drawn > 0 ? float(bytes[3]) / drawn : 0.f;
    model.part[cell] = part;
    model.mean.lightness += part * model.colour[cell].lightness;
    model.mean.a += part * model.colour[cell].a;
    model.mean.b += part * model.colour[cell].b;
  }
  return model;
}

}  // namespace tessera
