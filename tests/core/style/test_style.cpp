// The style of drawings made here, with known lines, colours, shades and textures.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "core/base/portable_math.h"
#include "core/quality/style_spread.h"
#include "core/style/style_groups.h"
#include "core/style/style_measure.h"
#include "core/style/style_weight.h"

namespace tessera {
namespace test_style {

constexpr int kSide_px = 270;
constexpr float kRadius_px = 126;  // this disc has an area of kStyleUnit_px squared
constexpr Lab kWhite{100, 0, 0}, kBlack{0, 0, 0}, kRed{53, 80, 67}, kOrange{75, 24, 78}, kBlue{32, 60, -90};

using Paint = std::function<Lab(float x_px, float y_px)>;  // x and y are relative to the middle

Lab mixed(const Lab& a, const Lab& b, float part_of_b) {
  const auto mix = [&](float x, float y) { return x + (y - x) * part_of_b; };
  return {mix(a.lightness, b.lightness), mix(a.a, b.a), mix(a.b, b.b)};
}

/// A disc with a black line along its edge. Edges are as soft as with antialiasing.
StyleRaster disc(float line_px, const Paint& paint) {
  StyleRaster raster{Grid<Lab>(kSide_px, kSide_px, kWhite), Grid<std::uint8_t>(kSide_px, kSide_px)};
  const auto within = [](float distance_px) { return std::clamp(0.5f - distance_px, 0.f, 1.f); };
  for (int y = 0; y < kSide_px; ++y) {
    for (int x = 0; x < kSide_px; ++x) {
      const float u = float(x) + 0.5f - kSide_px / 2, v = float(y) + 0.5f - kSide_px / 2;
      const float beyond_px = std::sqrt(u * u + v * v) - kRadius_px;
      const Lab lined = mixed(kBlack, paint(u, v), within(beyond_px + line_px));
      raster.colour(x, y) = mixed(kWhite, line_px > 0 ? lined : paint(u, v), within(beyond_px));
      raster.inside(x, y) = beyond_px < 0 ? 1 : 0;
    }
  }
  raster.unit_px = kRadius_px * std::sqrt(3.14159265f);
  return raster;
}

Paint flat(const Lab& colour) {
  return [=](float, float) { return colour; };
}

Lab shaded(float x, float y) { return {50 + x * 0.2f + y * 0.05f, 20, 30}; }

Lab noisy(float x, float y) {
  const auto key = std::uint64_t(int(x) + 1000) << 32 | std::uint64_t(int(y) + 1000);
  return {50 + 4 * (unit_float(std::uint32_t(mix_bits(key))) - 0.5f), 20, 30};
}

TEST(Style, the_width_of_a_contour_is_measured) {
  for (const float line_px : {2.f, 3.f, 4.5f, 7.f, 9.f}) {
    for (const Lab& fill : {kWhite, kOrange}) {
      const StyleFeatures style = measure_style(disc(line_px, flat(fill)));
      const float unit_px = kRadius_px * std::sqrt(3.14159265f);
      EXPECT_NEAR(style.line_width * unit_px, line_px, 0.15f * line_px);
      EXPECT_GT(style.outlined, 0.97f);
      EXPECT_NEAR(style.line_part, 2 * line_px / kRadius_px, 0.2f * 2 * line_px / kRadius_px);
    }
  }
}

TEST(Style, what_has_no_lines_has_none) {
  for (const Lab& fill : {kOrange, kBlack, kBlue}) {
    const StyleFeatures style = measure_style(disc(0, flat(fill)));
    EXPECT_EQ(style.line_width, 0);
    EXPECT_EQ(style.line_part, 0);
    EXPECT_EQ(style.outlined, 0);
  }
}

TEST(Style, broad_dark_areas_are_no_lines) {
  const StyleFeatures style = measure_style(disc(30, flat(kOrange)));
  EXPECT_LT(style.line_part, 0.01f);
}

TEST(Style, flat_colours_shades_and_texture_are_told_apart) {
  const StyleFeatures plain = measure_style(disc(0, flat(kOrange)));
  EXPECT_EQ(plain.shading, 0);
  EXPECT_LT(plain.texture, 1e-3f);
  const StyleFeatures gradient = measure_style(disc(0, shaded));
  EXPECT_GT(gradient.shading, 0.85f);
  EXPECT_LT(gradient.texture, 0.01f);
  const StyleFeatures noise = measure_style(disc(0, noisy));
  EXPECT_GT(noise.texture, 0.5f);
  EXPECT_LT(plain.detail, 0.1f);
}

TEST(Style, so_many_colours_in_equal_parts_have_the_bits_of_their_number) {
  const std::vector<Lab> colours = {kRed,          kBlue,      kOrange,       kBlack,
                                    {80, -60, 60}, {60, 0, 0}, {30, -20, 10}, {90, 0, 60}};
  for (const int count : {1, 2, 4, 8}) {
    const Paint sectors = [&](float x, float y) {
      const double turn = std::atan2(double(y), double(x)) / 6.283185307179586 + 0.5;
      return colours[std::size_t(turn * count) % std::size_t(count)];
    };
    EXPECT_NEAR(measure_style(disc(0, sectors)).palette, std::log2(float(count)), 0.1f) << count;
  }
}

TEST(Style, one_colour_has_no_bits_wherever_it_lies) {
  for (const Lab& colour : {kRed, kBlue, kOrange, kBlack, Lab{8.9f, 3.1f, -2.9f}})
    EXPECT_LT(measure_style(disc(0, flat(colour))).palette, 1e-6f);
}

TEST(Style, nothing_drawn_is_unknown) {
  EXPECT_FALSE(measure_style(StyleRaster{Grid<Lab>(9, 9, kWhite), Grid<std::uint8_t>(9, 9)}).known());
  EXPECT_FALSE(measure_style({}).known());
}

TEST(Style, what_is_enclosed_is_inside) {
  Grid<float> ring(9, 9);
  for (int i = 2; i <= 6; ++i) ring(i, 2) = ring(i, 6) = ring(2, i) = ring(6, i) = 1;
  const Grid<std::uint8_t> inside = enclosed_by(ring);
  EXPECT_EQ(inside(4, 4), 1);
  EXPECT_EQ(inside(0, 0), 0);
  EXPECT_EQ(std::accumulate(inside.data().begin(), inside.data().end(), 0), 25);
}

/// Blots and lines that follow from the seed.
StyleRaster random_drawing(std::uint64_t seed) {
  const auto number = [&](std::uint64_t k) { return unit_float(std::uint32_t(mix_bits(seed * 64 + k) >> 32)); };
  const float tilt = number(1) - 0.5f, wave = 5 + 20 * number(2), step = number(3);
  const Lab a{100 * number(4), 90 * number(5) - 45, 90 * number(6) - 45};
  const Lab b{100 * number(7), 90 * number(8) - 45, 90 * number(9) - 45};
  return disc(step > 0.5f ? 8 * number(10) : 0, [=](float x, float y) {
    const float place = (x + tilt * y) / wave;
    const float part = place - std::floor(place);
    return mixed(a, b, step > 0.7f ? part : part > 0.4f ? 1.f : 0.f);
  });
}

template <class T>
Grid<T> turned(const Grid<T>& grid) {
  Grid<T> result(grid.height(), grid.width());
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) result(grid.height() - 1 - y, x) = grid(x, y);
  }
  return result;
}

template <class T>
Grid<T> mirrored(Grid<T> grid) {
  for (int y = 0; y < grid.height(); ++y) std::reverse(grid.row(y), grid.row(y) + grid.width());
  return grid;
}

void expect_alike(const StyleRaster& a, const StyleRaster& b, float most) {
  RC_ASSERT(style_distance(style_place(measure_style(a)), style_place(measure_style(b))) <= most);
}

RC_GTEST_PROP(Style, does_not_change_with_a_quarter_turn_or_a_mirror_image, ()) {
  const StyleRaster drawing = random_drawing(*rc::gen::inRange<std::uint64_t>(0, 1000));
  expect_alike(drawing, {turned(drawing.colour), turned(drawing.inside), drawing.unit_px}, 1e-3f);
  expect_alike(drawing, {mirrored(drawing.colour), mirrored(drawing.inside), drawing.unit_px}, 1e-3f);
}

RC_GTEST_PROP(Style, does_not_change_with_the_hue, ()) {
  const StyleRaster drawing = random_drawing(*rc::gen::inRange<std::uint64_t>(0, 1000));
  const float cosine = 0.6f, sine = 0.8f;
  StyleRaster hued = drawing;
  for (Lab& c : hued.colour.data()) c = {c.lightness, cosine * c.a - sine * c.b, sine * c.a + cosine * c.b};
  expect_alike(drawing, hued, 0.1f);
}

StylePlace any_place() {
  StylePlace place;
  for (float& x : place) x = float(*rc::gen::inRange(-100, 100)) / 16;
  return place;
}

RC_GTEST_PROP(Style, distances_are_a_metric, ()) {
  const StylePlace a = any_place(), b = any_place(), c = any_place();
  RC_ASSERT(style_distance(a, a) == 0);
  RC_ASSERT(style_distance(a, b) == style_distance(b, a));
  RC_ASSERT(style_distance(a, c) <= (style_distance(a, b) + style_distance(b, c)) * 1.00001f);
}

TEST(StyleWeight, halves_with_each_unit_and_never_becomes_nothing) {
  EXPECT_EQ(style_worth(style_step(0, 1)), 1);
  EXPECT_EQ(style_worth(style_step(1, 1)), 0.5f);
  EXPECT_EQ(style_worth(style_step(1, 2)), 0.25f);
  EXPECT_EQ(style_step(0.2f, 1), 0);
  EXPECT_EQ(style_step(1000, 10), kMostStyleSteps);
  EXPECT_GT(style_worth(kMostStyleSteps), 0);
}

/// Three groups of 6, 9 and 3 places.
std::vector<StylePlace> heaps() {
  std::vector<StylePlace> places;
  for (int i = 0; i < 18; ++i) {
    StylePlace place{};
    place[0] = i % 3 == 0 ? 8.f : i % 6 == 1 ? 16.f : 0.f;
    place[1] = float(i) / 100;
    places.push_back(place);
  }
  return places;
}

TEST(StyleGroups, are_the_heaps_from_the_plainest_on_typical_ones_first) {
  const std::vector<StyleGroup> groups = style_groups(heaps(), 3);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].members.size(), 9u);
  EXPECT_EQ(groups[1].members.size(), 6u);
  EXPECT_EQ(groups[2].members.size(), 3u);
  EXPECT_EQ(groups[1].members.back() % 15, 0u) << "0 and 15 are the outermost";
  EXPECT_EQ(prevailing_style(std::vector<StylePlace>(5, StylePlace{1, 2})), 0u);
}

TEST(StyleGroups, are_no_more_than_there_are_styles) {
  EXPECT_EQ(style_groups(std::vector<StylePlace>(7, StylePlace{1, 2}), 4).size(), 1u);
  EXPECT_TRUE(style_groups({}, 4).empty());
}

JudgedPiece piece(const std::string& shape, double scale_px, float palette) {
  JudgedPiece piece{{}, shape, {}, scale_px};
  piece.style.palette = palette;
  return piece;
}

TEST(StyleSpread, is_the_mean_over_pairs_by_their_areas) {
  // The distance of two palettes is that of their bits. Each a (size 2) differs from b (size 3) by 1, and the two a differ by 0.
  const auto spread = mean_style_distance({piece("a", 2, 1), piece("a", 2, 1), piece("b", 3, 2)});
  ASSERT_TRUE(spread);
  EXPECT_NEAR(*spread, (2 * 4 * 9 * 1.0) / (2 * 4 * 9 + 4 * 4), 1e-6);
  EXPECT_EQ(mean_style_distance({piece("a", 2, 1), piece("b", 2, 1)}), 0);
  EXPECT_FALSE(mean_style_distance({piece("a", 2, 1)}));
  EXPECT_FALSE(mean_style_distance({piece("a", 2, 1), piece("b", 2, -1)})) << "one is unknown";
  EXPECT_FALSE(mean_style_distance({}));
}

}  // namespace test_style
}  // namespace tessera
