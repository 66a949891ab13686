// What it costs that drawings repeat themselves.
#include "core/replacing/repetition.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <utility>
#include <vector>

namespace tessera {
namespace {

constexpr double kShare_px2 = 3600;

ReplacementWindow window_of_drawings(const std::vector<DrawingArea>& drawn) {
  ReplacementWindow window;
  window.even_share_px2 = kShare_px2;
  window.repetition_cost = 0.5f;
  window.drawn = drawn;
  return window;
}

TEST(Repetition, EachEFoldOfEvenSharesCostsAPartOfTheArea) {
  EXPECT_NEAR(repeated_px2(100 * std::exp(1), 100), 0, 1e-6);
  EXPECT_NEAR(repeated_px2(100 * std::exp(3), 100), 2 * 100 * std::exp(3), 1e-5);
  EXPECT_NEAR(repeated_px2(101, 100), repeated_px2(99, 100), 1e-3) << "neutral at an even share";
  EXPECT_EQ(repeated_px2(0, 100), 0);
  const Repetition repetition(window_of_drawings({{ShapeId{0}, kShare_px2}, {ShapeId{2}, 4 * kShare_px2}}));
  const auto cost = [&](std::uint32_t drawing, double scale_px) {
    return repetition.cost_px2(ShapeId{drawing}, scale_px);
  };
  EXPECT_NEAR(cost(0, 60), 0.5 * kShare_px2 * (2 * std::log(2) - 1), 1e-3) << "the integral of ln x from 1 to 2";
  EXPECT_NEAR(cost(1, 60), -0.5 * kShare_px2, 1e-3) << "not listed: it covers nothing";
  EXPECT_GT(cost(2, 60), cost(0, 60)) << "of one that covers more";
  EXPECT_GT(cost(0, 120) / (120 * 120), cost(0, 60) / (60 * 60)) << "the eye goes by large copies";
  EXPECT_NEAR(cost(0, 40) + Repetition(window_of_drawings({{ShapeId{0}, kShare_px2 + 1600}})).cost_px2({}, 50),
              cost(0, std::sqrt(1600 + 2500)), 1e-3)
      << "two small ones cost as much as one that covers both";
}

TEST(Repetition, ItsEnergyIsThatOfAllDrawings) {
  EXPECT_TRUE(rc::check([] {
    const auto shape = [] { return ShapeId{*rc::gen::inRange(0u, 5u)}; };
    Repetition repetition(window_of_drawings({{ShapeId{1}, 5000}, {ShapeId{3}, 900}}));
    const double start_px2 = repetition.energy_px2();
    std::vector<std::pair<ShapeId, double>> added;
    double cost_px2 = 0;
    for (int k = *rc::gen::inRange(0, 8); k > 0; --k) {
      added.emplace_back(shape(), 0.01 * *rc::gen::inRange(2000, 16000));
      cost_px2 += repetition.cost_px2(added.back().first, added.back().second);
      repetition.add(added.back().first, added.back().second);
    }
    RC_ASSERT(std::abs(repetition.energy_px2() - start_px2 - cost_px2) < 1e-3);
    for (const auto& [drawing, scale_px] : added) repetition.remove(drawing, scale_px);
    RC_ASSERT(std::abs(repetition.energy_px2() - start_px2) < 1e-3);
  }));
}

}  // namespace
}  // namespace tessera
