// Colours for tests: drawings of two tones, and target pictures.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/colour/colour_grid.h"
#include "core/colour/colour_wish.h"

namespace tessera::test {

inline void paint(ColourGrid& grid, int cell, const Lab& lab, int part = 255) {
  grid.bytes[std::size_t(4 * cell)] = std::uint8_t(lab.lightness * 2.55f + 0.5f);
  grid.bytes[std::size_t(4 * cell + 1)] = std::uint8_t(lab.a + 128.5f);
  grid.bytes[std::size_t(4 * cell + 2)] = std::uint8_t(lab.b + 128.5f);
  grid.bytes[std::size_t(4 * cell + 3)] = std::uint8_t(part);
}

inline ColourGrid two_toned_grid(const Lab& left, const Lab& right) {
  ColourGrid grid;
  for (int cell = 0; cell < kColourCells; ++cell)
    paint(grid, cell, cell % kColourSide < kColourSide / 2 ? left : right);
  return grid;
}

/// A colour from the range that screens show. The same number gives the same colour.
inline Lab numbered_colour(std::uint32_t number) {
  return {float(15 + number * 37 % 75), float(int(number * 53 % 100) - 50), float(int(number * 71 % 100) - 50)};
}

/// A target whose texels have the colour `colour(p)`, where p is the texel's middle in canvas px.
inline std::shared_ptr<const ColourTarget> picture(int width_px, int height_px,
                                                   const std::function<Texel(Vec2)>& colour) {
  constexpr int kTexel_px = 2;
  Grid<Texel> finest((width_px + 1) / kTexel_px, (height_px + 1) / kTexel_px);
  for (int y = 0; y < finest.height(); ++y) {
    for (int x = 0; x < finest.width(); ++x) {
      finest(x, y) = colour({(float(x) + 0.5f) * kTexel_px, (float(y) + 0.5f) * kTexel_px});
    }
  }
  return std::make_shared<const ColourTarget>(finest, kTexel_px);
}

inline Texel opaque(const Lab& lab) { return {lab.lightness, lab.a, lab.b, 1}; }

/// A colour wish for shapes of one colour each (`of_shapes`), without contrasts inside a shape.
inline ColourWish wish_for(std::shared_ptr<const ColourTarget> target, const std::vector<Lab>& of_shapes,
                           float weight = 1) {
  std::vector<ShapeColour> colours;
  for (const Lab& mean : of_shapes) colours.push_back({mean});
  return {std::move(target), std::make_shared<const std::vector<ShapeColour>>(std::move(colours)), weight};
}

}  // namespace tessera::test
