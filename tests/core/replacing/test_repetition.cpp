// The cost of repeated drawings.
#include "core/replacing/repetition.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tessera {
namespace test_repetition {

constexpr double kShare_px2 = 3600;

ReplacementWindow window_of_drawings(const std::vector<DrawingArea>& drawn) {
  ReplacementWindow window;
  window.repetition = {0.5, kShare_px2, 0, 3};
  window.drawn = drawn;
  return window;
}

PlacedDrawing copy_at(float x, float y, float scale_px, std::uint32_t drawing = 0) {
  return {ShapeId{drawing}, {x, y}, scale_px};
}

TEST(Repetition, EachEFoldOfEvenSharesCostsAPartOfTheArea) {
  EXPECT_NEAR(repeated_px2(100 * std::exp(1), 100), 0, 1e-6);
  EXPECT_NEAR(repeated_px2(100 * std::exp(3), 100), 2 * 100 * std::exp(3), 1e-5);
  EXPECT_NEAR(repeated_px2(101, 100), repeated_px2(99, 100), 1e-3) << "neutral at an even share";
  EXPECT_EQ(repeated_px2(0, 100), 0);
  const Repetition repetition(window_of_drawings({{ShapeId{0}, kShare_px2}, {ShapeId{2}, 4 * kShare_px2}}));
  const auto cost = [&](std::uint32_t drawing, float scale_px) {
    return repetition.cost_px2(copy_at(0, 0, scale_px, drawing));
  };
  EXPECT_NEAR(cost(0, 60), 0.5 * kShare_px2 * (2 * std::log(2) - 1), 1e-3) << "the integral of ln x from 1 to 2";
  EXPECT_NEAR(cost(1, 60), -0.5 * kShare_px2, 1e-3) << "not listed: it covers nothing";
  EXPECT_GT(cost(2, 60), cost(0, 60)) << "of one that covers more";
  EXPECT_GT(cost(0, 120) / (120 * 120), cost(0, 60) / (60 * 60)) << "the eye goes by large copies";
  const Repetition with_more(window_of_drawings({{ShapeId{0}, kShare_px2 + 1600}}));
  EXPECT_NEAR(cost(0, 40) + with_more.cost_px2(copy_at(0, 0, 50)), cost(0, std::sqrt(1600.f + 2500.f)), 1e-2)
      << "two small ones cost as much as one that covers both";
}

TEST(Repetition, OfTwoCopiesTheSmallerOneCostsByHowNearTheyAre) {
  EXPECT_NEAR(near_px2(copy_at(0, 0, 90), copy_at(0, 0, 40), 5), 1600, 1e-3);
  EXPECT_NEAR(near_px2(copy_at(0, 0, 40), copy_at(90, 120, 90), 5), 1600 * (1 - 150. / (5 * 60)), 1e-2);
  EXPECT_EQ(near_px2(copy_at(0, 0, 40), copy_at(301, 0, 90), 5), 0);
  EXPECT_GT(near_px2(copy_at(0, 0, 40), copy_at(299, 0, 90), 5), 0);
  EXPECT_EQ(near_px2(copy_at(0, 0, 40), copy_at(121, 0, 90), 2), 0);
}

TEST(Repetition, NearCopiesCostMoreThanFarOnes) {
  ReplacementWindow window = window_of_drawings({});
  window.repetition = {0, kShare_px2, 2, 5};
  window.moving = {{ShapeId{7}, ShapeId{3}, {50, 0, 100, 100}, {}}};
  window.elsewhere = {copy_at(500, 100, 50, 3), copy_at(100, 100, 50, 2)};
  const Repetition repetition(window);
  EXPECT_NEAR(repetition.cost_px2(copy_at(150, 100, 50, 3)), 2 * 2500 * (1 - 50. / 250), 1e-2) << "of what moves";
  EXPECT_NEAR(repetition.cost_px2(copy_at(450, 100, 50, 3)), 2 * 2500 * (1 - 50. / 250), 1e-2) << "of what does not";
  EXPECT_EQ(repetition.cost_px2(copy_at(150, 100, 50, 4)), 0);
}

TEST(Repetition, OnASeamlessCanvasCopiesAreNearAcrossItsEdge) {
  const RepetitionCosts costs{0, 1, 1, 5};
  const std::vector<PlacedDrawing> pieces = {copy_at(10, 50, 20), copy_at(390, 50, 20)};
  EXPECT_EQ(repetition_px2(pieces, costs, {}), 0);
  EXPECT_NEAR(repetition_px2(pieces, costs, {400, 0}), 400 * (1 - 20. / 100), 1e-3);
}

std::vector<PlacedDrawing> any_pieces() {
  std::vector<PlacedDrawing> pieces;
  for (int k = *rc::gen::inRange(0, 12); k > 0; --k) {
    const auto any = [](int low, int high) { return 0.01f * float(*rc::gen::inRange(100 * low, 100 * high)); };
    pieces.push_back(copy_at(any(0, 600), any(0, 600), any(20, 160), *rc::gen::inRange(0u, 4u)));
  }
  return pieces;
}

/// The cost of a window's pieces changes as much as that of all pieces of the canvas.
TEST(Repetition, ItsEnergyIsThatOfAllPieces) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<PlacedDrawing> stand = any_pieces();
    ReplacementWindow window = window_of_drawings({});
    window.repetition.nearness = 0.7;
    for (std::uint32_t i = 0; i < 4; ++i) {
      double area_px2 = 0;
      for (const PlacedDrawing& p : stand) area_px2 += index_of(p.drawing) == i ? double(p.scale_px) * p.scale_px : 0;
      window.drawn.push_back({ShapeId{i}, area_px2});
    }
    window.elsewhere = stand;
    Repetition repetition(window);
    const auto of_all_px2 = [&](const std::vector<PlacedDrawing>& all) {
      return repetition_px2(all, window.repetition, {});
    };
    const std::vector<PlacedDrawing> added = any_pieces();
    std::vector<PlacedDrawing> all = stand;
    double cost_px2 = 0;
    for (const PlacedDrawing& piece : added) {
      cost_px2 += repetition.cost_px2(piece);
      repetition.add(piece);
      all.push_back(piece);
    }
    RC_ASSERT(std::abs(repetition.energy_px2() - cost_px2) < 0.1);
    RC_ASSERT(std::abs(of_all_px2(all) - of_all_px2(stand) - cost_px2) < 0.1);
    std::reverse(all.begin(), all.end());
    RC_ASSERT(std::abs(of_all_px2(all) - of_all_px2(stand) - cost_px2) < 0.1);
    for (const PlacedDrawing& piece : added) repetition.remove(piece);
    RC_ASSERT(std::abs(repetition.energy_px2()) < 0.1);
  }));
}

}  // namespace test_repetition
}  // namespace tessera
