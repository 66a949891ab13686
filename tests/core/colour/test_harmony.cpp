// Harmonic templates: the template that fits hues, its angle, and the new hues.
#include "core/colour/harmony.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "support/input_error.h"

namespace tessera {
namespace test_harmony {

using enum HarmonicTemplate;

HueHistogram histogram_of(const std::vector<std::pair<int, double>>& hues) {
  HueHistogram weights{};
  for (const auto& [hue, weight] : hues) weights[std::size_t((hue % kHues + kHues) % kHues)] += weight;
  return weights;
}

HueHistogram turned(const HueHistogram& weights, int turn_deg) {
  HueHistogram result{};
  for (int hue = 0; hue < kHues; ++hue) result[std::size_t((hue + turn_deg) % kHues)] = weights[std::size_t(hue)];
  return result;
}

/// The distance to the nearest sector of the template, with the paper's sectors.
double outside_deg(double hue, const Harmony& harmony) {
  const auto from = [&](double centre, double width) {
    return std::max(0., std::abs(std::remainder(hue - harmony.angle_deg - centre, 360)) - width / 2);
  };
  switch (harmony.form) {
    case i: return from(0, 18);
    case I: return std::min(from(0, 18), from(180, 18));
    case V: return from(0, 93.6);
    case L: return std::min(from(0, 18), from(90, 79.2));
    case Y: return std::min(from(0, 93.6), from(180, 18));
    case T: return from(0, 180);
    case X: return std::min(from(0, 93.6), from(180, 93.6));
  }
  return -1;
}

HueHistogram any_weights() {
  HueHistogram weights{};
  for (int k = *rc::gen::inRange(1, 12); k > 0; --k)
    weights[std::size_t(*rc::gen::inRange(0, kHues))] += *rc::gen::inRange(1, 100);
  return weights;
}

Harmony any_harmony() { return {*rc::gen::elementOf(kHarmonicTemplates), *rc::gen::inRange(0, kHues)}; }

TEST(Harmony, TemplatesAreCalledAsInThePaper) {
  std::string letters;
  for (const HarmonicTemplate form : kHarmonicTemplates) {
    letters += letter_of(form);
    EXPECT_EQ(template_of(letter_of(form)), form);
  }
  EXPECT_EQ(letters, "iIVLYTX");
  for (const char* wrong : {"", "v", "N", "iI", "none"})
    EXPECT_NE(test::message_of([&] { template_of(wrong); }).find("allowed: i, I"), std::string::npos) << wrong;
}

RC_GTEST_PROP(Harmony, DisharmonyIsTheWayToTheNearestSector, ()) {
  const HueHistogram weights = any_weights();
  const Harmony harmony = any_harmony();
  double sum = 0;
  for (int hue = 0; hue < kHues; ++hue) sum += weights[std::size_t(hue)] * outside_deg(hue, harmony);
  RC_ASSERT(std::abs(disharmony(weights, harmony) - sum) < 1e-6);
}

RC_GTEST_PROP(Harmony, TheAngleIsTheBestOfAll, ()) {
  const HueHistogram weights = any_weights();
  const HarmonicTemplate form = *rc::gen::elementOf(kHarmonicTemplates);
  const Harmony best = best_harmony(weights, form);
  RC_ASSERT(best.form == form);
  for (int angle = 0; angle < kHues; ++angle)
    RC_ASSERT(disharmony(weights, {form, angle}) >= disharmony(weights, best));
}

RC_GTEST_PROP(Harmony, TheTemplateIsTheBestOfAll, ()) {
  const HueHistogram weights = any_weights();
  const double least = disharmony(weights, best_harmony(weights));
  for (const HarmonicTemplate form : kHarmonicTemplates)
    RC_ASSERT(disharmony(weights, best_harmony(weights, form)) >= least);
}

TEST(Harmony, OfTemplatesThatFitAlikeTheNarrowestIsTaken) {
  EXPECT_EQ(best_harmony(histogram_of({{40, 1}, {50, 1}})).form, i);
  EXPECT_EQ(best_harmony(histogram_of({{40, 1}, {220, 1}})).form, I);
  EXPECT_EQ(best_harmony(histogram_of({{40, 1}, {100, 1}})).form, V);
  EXPECT_EQ(best_harmony(histogram_of({{40, 1}, {160, 1}})).form, L);
  EXPECT_EQ(best_harmony(histogram_of({{0, 1}, {46, 1}, {92, 1}, {226, 1}})).form, Y);
  EXPECT_EQ(best_harmony(histogram_of({{0, 1}, {60, 1}, {120, 1}, {178, 1}})).form, T);
  EXPECT_EQ(best_harmony(histogram_of({{0, 1}, {92, 1}, {180, 1}, {272, 1}})).form, X);
}

/// These hues allow the template only one angle: the middle one, in degrees.
RC_GTEST_PROP(Harmony, TheAngleFollowsTheHues, ()) {
  const int turn = *rc::gen::inRange(0, kHues);
  const HueHistogram weights = turned(histogram_of({{0, 3}, {46, 1}, {92, 3}}), turn);
  RC_ASSERT(best_harmony(weights, V) == (Harmony{V, (46 + turn) % kHues}));
}

RC_GTEST_PROP(Harmony, TurningAllHuesChangesNoDisharmony, ()) {
  const HueHistogram weights = any_weights();
  const HueHistogram there = turned(weights, *rc::gen::inRange(0, kHues));
  for (const HarmonicTemplate form : kHarmonicTemplates) {
    const double here = disharmony(weights, best_harmony(weights, form));
    RC_ASSERT(std::abs(disharmony(there, best_harmony(there, form)) - here) < 1e-6);
  }
}

RC_GTEST_PROP(Harmony, WhatLiesInASectorStays, ()) {
  const Harmony harmony = any_harmony();
  for (int hue = 0; hue < kHues; ++hue) {
    if (outside_deg(hue, harmony) == 0) RC_ASSERT(harmonised_hue(hue, harmony) == hue);
  }
}

RC_GTEST_PROP(Harmony, EveryHueEndsInTheNearestSector, ()) {
  const Harmony harmony = any_harmony();
  for (int hue = 0; hue < kHues; ++hue) {
    const double there = harmonised_hue(hue, harmony);
    RC_ASSERT(there >= 0 && there < kHues);
    RC_ASSERT(outside_deg(there, harmony) < 1e-9);
    const double way = std::abs(std::remainder(there - hue, 360));
    RC_ASSERT(way <= outside_deg(hue, harmony) + 93.6);  // this hue is one sector of T away, which is its own nearest
  }
}

TEST(Harmony, GoesByTheGaussianOfThePaper) {
  const auto there = [](double d, double width) {
    const double sigma = width / 2;
    return sigma * (1 - std::exp(-d * d / (2 * sigma * sigma)));
  };
  EXPECT_NEAR(harmonised_hue(100 + 60, {V, 100}), 100 + there(60, 93.6), 1e-9);
  EXPECT_NEAR(harmonised_hue(100 - 60, {V, 100}), 100 - there(60, 93.6), 1e-9);
  EXPECT_NEAR(harmonised_hue(330, {V, 100}), 100 - there(130, 93.6), 1e-9) << "across 0";
  EXPECT_NEAR(harmonised_hue(350, {i, 10}), 10 - there(20, 18), 1e-9);
  EXPECT_NEAR(harmonised_hue(340, {i, 2}), 360 + 2 - there(22, 18), 1e-9);
  EXPECT_NEAR(harmonised_hue(160, {Y, 0}), 180 - there(20, 18), 1e-9) << "to the sector that is nearer";
  EXPECT_NEAR(harmonised_hue(100, {Y, 0}), there(100, 93.6), 1e-9);
}

}  // namespace test_harmony
}  // namespace tessera
