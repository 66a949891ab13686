#include <gtest/gtest.h>

#include <numeric>

#include "core/colour/ciede2000.h"
#include "core/colour/colour_grid.h"
#include "core/colour/palette_difference.h"
#include "support/colours.h"

namespace tessera {
namespace test_colour_grid {

const Lab kRed{53, 80, 67};
const Lab kBlue{32, 79, -108};

/// A raster that is red on the left, blue on the right, and empty in the lowest quarter.
ColourRaster flag(int width, int height) {
  ColourRaster raster{Grid<Lab>(width, height), Grid<float>(width, height, 1.f), {0, 0}, {1, 1}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      raster.colour(x, y) = x < width / 2 ? kRed : kBlue;
      if (y >= height * 3 / 4) raster.alpha(x, y) = 0;
    }
  }
  return raster;
}

void expect_colour(const Lab& found, const Lab& expected) {
  EXPECT_NEAR(found.lightness, expected.lightness, 0.21f);
  EXPECT_NEAR(found.a, expected.a, 0.51f);
  EXPECT_NEAR(found.b, expected.b, 0.51f);
}

TEST(PaletteDifference, IsTheMeanOfWhatIsDrawnToTheNearestColours) {
  const ColourGrid grid = make_colour_grid(flag(40, 16), {0, 0}, {40, 16});
  const Lab red_and_blue[] = {kBlue, kRed};
  EXPECT_LT(palette_difference(grid, red_and_blue), 0.5f);
  const Lab blue[] = {kBlue};
  EXPECT_NEAR(palette_difference(grid, blue), 0.5f * ciede2000(kRed, kBlue), 0.5f);
  EXPECT_EQ(palette_difference(ColourGrid{}, blue), 0);
}

TEST(ColourGrid, HoldsTheMeanOfEachCell) {
  const ColourGrid grid = make_colour_grid(flag(40, 16), {0, 0}, {40, 16});
  EXPECT_TRUE(grid.known());
  const ColourModel model = make_colour_model(grid, {-2, -1}, {2, 1});
  for (int cell = 0; cell < kColourCells; ++cell) {
    if (cell >= 12) {
      EXPECT_EQ(model.part[cell], 0) << cell;
      continue;
    }
    expect_colour(model.colour[cell], cell % 4 < 2 ? kRed : kBlue);
    EXPECT_FLOAT_EQ(model.part[cell], 1.f / 12) << cell;
  }
  expect_colour(model.mean, {42.5f, 79.5f, -20.5f});
  EXPECT_FLOAT_EQ(model.cell, std::sqrt(0.5f));
  EXPECT_EQ(model.at[0], (Vec2{-1.5f, -0.75f}));
  EXPECT_EQ(model.at[7], (Vec2{1.5f, -0.25f}));
}

TEST(ColourGrid, KnowsItsOwnContrast) {
  const auto striped = [](const Lab& left, const Lab& right) {
    ColourRaster raster = flag(16, 16);
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) raster.colour(x, y) = x < 8 ? left : right;
    }
    return own_contrast(make_colour_grid(raster, {0, 0}, {16, 16}));
  };
  EXPECT_NEAR(striped({60, 0, 0}, {60, 0, 0}), 0, 0.1f);
  EXPECT_NEAR(striped({40, 0, 0}, {80, 0, 0}), 20, 0.3f);
  EXPECT_NEAR(striped({60, -20, 0}, {60, 20, 0}), 10, 0.5f) << "hues count half";
  EXPECT_EQ(own_contrast(ColourGrid{}), 0);
}

TEST(ColourGrid, IsOfTheBoxAlone) {
  ColourRaster raster = flag(40, 16);
  raster.origin_px = {100, 50};
  raster.pixel_px = {2, 3};
  const ColourGrid grid = make_colour_grid(raster, {100, 50}, {140, 86});  // the left half, without its empty part
  const ColourModel model = make_colour_model(grid, {0, 0}, {1, 1});
  for (int cell = 0; cell < kColourCells; ++cell) expect_colour(model.colour[cell], kRed);
}

/// A half-transparent pixel has half the weight.
TEST(ColourGrid, WeighsByAlpha) {
  ColourRaster raster{Grid<Lab>(8, 8, kRed), Grid<float>(8, 8, 1.f), {0, 0}, {1, 1}};
  for (int y = 0; y < 8; ++y) {
    raster.colour(1, y) = kBlue;
    raster.alpha(1, y) = 0.25f;
  }
  const ColourModel model = make_colour_model(make_colour_grid(raster, {0, 0}, {8, 8}), {0, 0}, {1, 1});
  expect_colour(model.colour[0], {(53 + 0.25f * 32) / 1.25f, (80 + 0.25f * 79) / 1.25f, (67 - 0.25f * 108) / 1.25f});
  EXPECT_NEAR(model.part[0] / model.part[1], 1.25f / 2, 0.01f);
}

TEST(ColourGrid, OfNothingIsUnknown) {
  EXPECT_FALSE(ColourGrid().known());
  EXPECT_FALSE(make_colour_grid({}, {0, 0}, {1, 1}).known());
  const ColourModel model = make_colour_model({}, {0, 0}, {1, 1});
  EXPECT_EQ(std::accumulate(model.part.begin(), model.part.end(), 0.f), 0);
}

TEST(ColourGrid, MirroredIsThatOfTheMirroredDrawing) {
  ColourGrid grid = test::two_toned_grid(kRed, kBlue);
  test::paint(grid, 5, {70, 0, 0}, 40);
  const ColourGrid other = mirrored(grid);
  EXPECT_EQ(mirrored(other), grid);
  const ColourModel model = make_colour_model(other, {-1, -1}, {1, 1});
  expect_colour(model.colour[0], kBlue);
  expect_colour(model.colour[3], kRed);
  expect_colour(model.colour[6], {70, 0, 0});
}

}  // namespace test_colour_grid
}  // namespace tessera
