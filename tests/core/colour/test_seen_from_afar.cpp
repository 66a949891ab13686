// Measures of a mosaic seen from afar: means of areas, CIELAB, SSIM and both figures.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/colour/ciede2000.h"
#include "core/colour/seen_from_afar.h"
#include "core/colour/ssim.h"

namespace tessera {
namespace test_seen_from_afar {

Grid<WeightedColour> cells_of(const Grid<WeightedColour>& pixels, int width, int height) {
  AreaMeans means(pixels.width(), pixels.height(), width, height);
  for (int y = 0; y < pixels.height(); ++y) means.add_row(pixels.row(y));
  return means.cells();
}

/// A picture of computed colours, without a pattern that could match a grid of cells.
Grid<Srgb> patterned(int width, int height, int seed) {
  Grid<Srgb> picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture(x, y) = {float((x * 23 + y * 41 + x * y * 7 + seed) % 256), float((x * 31 + y * 29 + seed * 3) % 256),
                       float((x * 13 + y * 59 + x * y * 3 + seed * 7) % 256)};
    }
  }
  return picture;
}

Grid<WeightedColour> weighted(const Grid<Srgb>& picture) {
  Grid<WeightedColour> pixels(picture.width(), picture.height());
  for (std::size_t i = 0; i < pixels.data().size(); ++i) pixels.data()[i].colour = picture.data()[i];
  return pixels;
}

Grid<float> ones(int width, int height) { return {width, height, 1.f}; }

PicturePair pair_of(const Grid<Srgb>& mosaic, const Grid<Srgb>& picture) {
  return {mosaic, picture, ones(mosaic.width(), mosaic.height())};
}

TEST(AreaMeans, PixelsCountByWhatACellHasOfThem) {
  Grid<WeightedColour> pixels(3, 1);
  pixels(0, 0).colour.red = 30;
  pixels(1, 0).colour.red = 60;
  pixels(2, 0).colour.red = 120;
  const auto cells = cells_of(pixels, 2, 1);
  EXPECT_FLOAT_EQ(cells(0, 0).colour.red, (30 + 60 / 2.f) / 1.5f);
  EXPECT_FLOAT_EQ(cells(1, 0).colour.red, (60 / 2.f + 120) / 1.5f);
}

TEST(AreaMeans, WhatDoesNotCountHasNoColour) {
  Grid<WeightedColour> pixels(4, 2);
  for (auto& pixel : pixels.data()) pixel = {{200, 100, 50}, 0};
  pixels(0, 0) = {{10, 20, 30}, 0.5f};
  const auto cells = cells_of(pixels, 2, 1);
  EXPECT_EQ(cells(0, 0).colour, (Srgb{10, 20, 30}));
  EXPECT_FLOAT_EQ(cells(0, 0).weight, 0.5f / 4);
  EXPECT_EQ(cells(1, 0).colour, (Srgb{0, 0, 0}));
  EXPECT_EQ(cells(1, 0).weight, 0);
}

RC_GTEST_PROP(AreaMeansProperty, TheMeanOfAllStaysWhateverTheGrid, ()) {
  const int width = *rc::gen::inRange(1, 40), height = *rc::gen::inRange(1, 40);
  const int columns = *rc::gen::inRange(1, 50), rows = *rc::gen::inRange(1, 50);
  const auto pixels = weighted(patterned(width, height, *rc::gen::inRange(0, 256)));
  const auto mean = cells_of(pixels, 1, 1)(0, 0).colour,
             again = cells_of(cells_of(pixels, columns, rows), 1, 1)(0, 0).colour;
  RC_ASSERT(std::abs(mean.red - again.red) < 1e-3f);
  RC_ASSERT(std::abs(mean.green - again.green) < 1e-3f);
  RC_ASSERT(std::abs(mean.blue - again.blue) < 1e-3f);
}

/// The values are those of scikit-image's rgb2lab.
TEST(Srgb, LabIsThePublishedOne) {
  const auto expect = [](const Srgb& colour, const Lab& wanted) {
    const Lab lab = lab_from_srgb(colour);
    EXPECT_NEAR(lab.lightness, wanted.lightness, 0.02);
    EXPECT_NEAR(lab.a, wanted.a, 0.02);
    EXPECT_NEAR(lab.b, wanted.b, 0.02);
  };
  expect({255, 0, 0}, {53.2406f, 80.0923f, 67.2028f});
  expect({0, 128, 255}, {54.7145f, 18.7735f, -70.9138f});
  expect({12, 34, 56}, {12.6562f, 0.1214f, -16.8316f});
  expect({200, 180, 90}, {73.3257f, -4.2243f, 47.8750f});
  expect({255, 255, 255}, {100, 0, 0});
  expect({0, 0, 0}, {0, 0, 0});
}

Grid<float> greys(int width, int height, float (*at)(int, int)) {
  Grid<float> picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) picture(x, y) = at(x, y);
  }
  return picture;
}

float first(int x, int y) { return float((x * 23 + y * 41 + x * y * 7) % 256); }
float second(int x, int y) { return float((x * 31 + y * 29 + x * y * 5 + 40) % 256); }
float waved(int x, int y) { return std::clamp(first(x, y) + 20 * std::sin(float(x + 2 * y)), 0.f, 255.f); }

/// The values are those of structural_similarity in scikit-image 0.19 with data_range 255.
TEST(Ssim, IsThatOfScikitImage) {
  const auto a = greys(11, 9, first);
  EXPECT_NEAR(ssim(a, greys(11, 9, second), ones(11, 9)), 0.36005149818766313, 1e-6);
  EXPECT_NEAR(ssim(a, greys(11, 9, waved), ones(11, 9)), 0.9837230835050403, 1e-6);
}

RC_GTEST_PROP(SsimProperty, IsOneForEqualsAndSymmetric, ()) {
  const int width = *rc::gen::inRange(1, 20), height = *rc::gen::inRange(1, 20);
  Grid<float> a(width, height), b(width, height), weight(width, height);
  for (float& value : a.data()) value = float(*rc::gen::inRange(0, 256));
  for (float& value : b.data()) value = float(*rc::gen::inRange(0, 256));
  for (float& value : weight.data()) value = float(*rc::gen::inRange(0, 5)) / 4;
  RC_ASSERT(std::abs(ssim(a, a, weight) - 1) < 1e-9);
  RC_ASSERT(std::abs(ssim(a, b, weight) - ssim(b, a, weight)) < 1e-9);
  RC_ASSERT(std::abs(ssim(a, b, weight)) <= 1 + 1e-9);
}

TEST(Ssim, FallsWithNoise) {
  const auto a = greys(40, 30, [](int x, int y) { return 60 + 3.f * float(x) + 2.f * float(y); });
  double before = 1;
  for (const float noise : {5.f, 15.f, 45.f}) {
    Grid<float> b = a;
    for (std::size_t i = 0; i < b.data().size(); ++i) b.data()[i] += i * 7919 % 2 == 0 ? noise : -noise;
    const double now = ssim(a, b, ones(40, 30));
    EXPECT_LT(now, before - 0.05) << noise;
    before = now;
  }
}

TEST(Ssim, WhatDoesNotCountIsNotSeen) {
  const auto a = greys(30, 20, first);
  Grid<float> b = a, weight = ones(30, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 20; x < 30; ++x) {
      b(x, y) = 255 - b(x, y);
      weight(x, y) = 0;
    }
  }
  EXPECT_LT(ssim(a, b, ones(30, 20)), 0.8);
  EXPECT_NEAR(ssim(a, b, weight), 1, 1e-9);
  EXPECT_EQ(ssim(a, b, Grid<float>(30, 20, 0.f)), 1);
}

TEST(SeenFromAfar, EqualPicturesAreEqual) {
  const auto seen = seen_from_afar(pair_of(patterned(240, 160, 1), patterned(240, 160, 1)), 30);
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->at_100_px.width_px, 100);
  EXPECT_EQ(seen->at_100_px.height_px, 67);
  EXPECT_EQ(seen->at_100_px.colour_difference, 0);
  EXPECT_NEAR(seen->at_100_px.structure, 1, 1e-9);
  EXPECT_EQ(seen->at_piece_size.value().width_px, 30);
  EXPECT_EQ(seen->at_piece_size.value().height_px, 20);
}

/// A chequered mosaic of black and white is grey from afar. Where its cells are seen, it differs from grey.
TEST(SeenFromAfar, PiecesMelt) {
  Grid<Srgb> mosaic(400, 200), picture(400, 200, Srgb{127.5f, 127.5f, 127.5f});
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 400; ++x) {
      const float grey = (x / 2 + y / 2) % 2 == 0 ? 255.f : 0.f;
      mosaic(x, y) = {grey, grey, grey};
    }
  }
  EXPECT_NEAR(figures_from_afar(pair_of(mosaic, picture), 100).value().colour_difference, 0, 1e-3);
  EXPECT_GT(figures_from_afar(pair_of(mosaic, picture), 400).value().colour_difference, 30);
}

TEST(SeenFromAfar, OneColourForAnotherIsTheirDifference) {
  const Srgb a{200, 30, 60}, b{10, 120, 240};
  const auto figures = figures_from_afar(pair_of(Grid<Srgb>(120, 90, a), Grid<Srgb>(120, 90, b)), 100).value();
  EXPECT_NEAR(figures.colour_difference, double(ciede2000(lab_from_srgb(a), lab_from_srgb(b))), 1e-4);
}

TEST(SeenFromAfar, OnlyWhatCountsIsCompared) {
  PicturePair pair = pair_of(patterned(200, 100, 1), patterned(200, 100, 1));
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 77; ++x) {
      pair.mosaic(x, y) = {255, 0, 255};
      pair.weight(x, y) = 0;
    }
  }
  const auto figures = figures_from_afar(pair, 100).value();
  EXPECT_EQ(figures.colour_difference, 0);
  EXPECT_NEAR(figures.structure, 1, 1e-9);
  pair.weight = Grid<float>(200, 100, 0.f);
  EXPECT_FALSE(seen_from_afar(pair, 10));
}

TEST(SeenFromAfar, AnySizeHasFigures) {
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 500}, {700, 2}, {40, 30}}) {
    const auto seen = seen_from_afar(pair_of(patterned(width, height, 1), patterned(width, height, 9)), 1e9).value();
    EXPECT_EQ(seen.at_100_px.width_px, std::min(width, 100));
    EXPECT_EQ(seen.at_piece_size.value().width_px, width) << "no finer than the cells";
    for (const AfarFigures& figures : {seen.at_100_px, seen.at_piece_size.value()}) {
      EXPECT_TRUE(figures.colour_difference > 0 && figures.colour_difference < 120) << width << " x " << height;
      EXPECT_TRUE(figures.structure >= -1 && figures.structure <= 1) << width << " x " << height;
    }
  }
  EXPECT_FALSE(seen_from_afar(pair_of(patterned(9, 9, 1), patterned(9, 9, 2)), 0).value().at_piece_size);
}

}  // namespace test_seen_from_afar
}  // namespace tessera
