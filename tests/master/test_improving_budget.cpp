// The number of trials for improving: by regions, by number and by time.
#include "master/improving_budget.h"

#include <gtest/gtest.h>

namespace tessera::master {
namespace test_improving_budget {

using Replaced = ImprovingBudget::Replaced;

/// 10,000 px² in two regions, of which the second is three times as large as the first.
Canvas two_regions() {
  Canvas canvas;
  canvas.area_px2 = 10'000;
  canvas.regions.resize(2);
  canvas.regions[0].area_px2 = 2'500;
  canvas.regions[1].area_px2 = 7'500;
  return canvas;
}

CollageSettings improving(int trials, double improve_s = 0, double stop_s = 0) {
  CollageSettings s;
  s.improve.trials = trials;
  s.improve.seconds = improve_s;
  s.stop.seconds = stop_s;
  return s;
}

TEST(ImprovingBudget, DividesTrialsByArea) {
  const Canvas canvas = two_regions();
  const CollageSettings s = improving(50);
  const ImprovingBudget budget(canvas, s);
  EXPECT_EQ(budget.area_px2(0), 2'500);
  EXPECT_EQ(budget.area_px2(1), 7'500);
  EXPECT_EQ(budget.first_trial(0), 0u);
  EXPECT_EQ(budget.first_trial(1), 12u);
  EXPECT_TRUE(budget.may_go_on(0, 11, 1e6));
  EXPECT_FALSE(budget.may_go_on(0, 12, 0));
  EXPECT_TRUE(budget.may_go_on(1, 12, 0));
  EXPECT_TRUE(budget.may_go_on(1, 49, 0));
  EXPECT_FALSE(budget.may_go_on(1, 50, 0));
}

/// Each region, however small, gets a trial that moves all of its pieces.
TEST(ImprovingBudget, EachRegionHasATrialWhereThereAreAsMany) {
  Canvas canvas = two_regions();
  canvas.regions.push_back({{}, 1});
  canvas.regions[1].area_px2 = 7'499;
  const auto first_trials = [&](int trials) {
    const CollageSettings s = improving(trials);
    const ImprovingBudget budget(canvas, s);
    return std::vector{budget.first_trial(0), budget.first_trial(1), budget.first_trial(2)};
  };
  EXPECT_EQ(first_trials(2), (std::vector<std::uint64_t>{0, 0, 1})) << "too few";
  EXPECT_EQ(first_trials(3), (std::vector<std::uint64_t>{0, 1, 2}));
  EXPECT_EQ(first_trials(100), (std::vector<std::uint64_t>{0, 25, 99}));
  EXPECT_EQ(first_trials(100'000), (std::vector<std::uint64_t>{0, 25'000, 99'990})) << "by area alone";
}

TEST(ImprovingBudget, WithoutRegionsTheCanvasHasAll) {
  Canvas canvas;
  canvas.area_px2 = 10'000;
  const CollageSettings s = improving(50);
  const ImprovingBudget budget(canvas, s);
  EXPECT_EQ(budget.area_px2(0), 10'000);
  EXPECT_EQ(budget.first_trial(0), 0u);
  EXPECT_TRUE(budget.may_go_on(0, 49, 0));
  EXPECT_FALSE(budget.may_go_on(0, 50, 0));
}

/// The first limit that is reached counts; the time is divided among regions, too.
TEST(ImprovingBudget, EndsByTimeToo) {
  const Canvas canvas = two_regions();
  const CollageSettings timed = improving(0, 4);
  const ImprovingBudget by_time(canvas, timed);
  EXPECT_TRUE(by_time.may_go_on(0, 1'000'000, 0.9));
  EXPECT_FALSE(by_time.may_go_on(0, 0, 1));
  EXPECT_TRUE(by_time.may_go_on(1, 0, 3.9));
  EXPECT_FALSE(by_time.may_go_on(1, 0, 4));
  const CollageSettings both = improving(50, 4);
  EXPECT_FALSE(ImprovingBudget(canvas, both).may_go_on(0, 0, 1));
  EXPECT_FALSE(ImprovingBudget(canvas, both).may_go_on(0, 12, 0));
  EXPECT_TRUE(ImprovingBudget(canvas, both).may_go_on(0, 11, 0.9));
}

/// Eight replacements for each of five sixths of the region's trials. The trials before and after that phase have none.
TEST(ImprovingBudget, ReplacementsFollowFromTheRegionsTrials) {
  const Canvas canvas = two_regions();
  const CollageSettings s = improving(50);
  const ImprovingBudget budget(canvas, s);
  for (const Replaced so_far : {Replaced{}, Replaced{40, 1e6, 1e6}}) {
    EXPECT_EQ(budget.replacements(0, 7, so_far), 66u);   // 8 · 5/6 · 10
    EXPECT_EQ(budget.replacements(1, 7, so_far), 240u);  // 8 · 5/6 · 36
  }
  for (const int few : {1, 2, 3}) {
    const CollageSettings little = improving(few);
    EXPECT_EQ(ImprovingBudget(canvas, little).replacements(0, 7, {}), 0u);
  }
}

TEST(ImprovingBudget, ReplacementsFollowFromTime) {
  const Canvas canvas = two_regions();
  const CollageSettings s = improving(0, 48);  // 12 s and 36 s
  const ImprovingBudget budget(canvas, s);
  EXPECT_EQ(budget.replacements(0, 7, {}), 420u) << "nothing is known as yet: 60 for each piece";
  // 100 trials took 2 s of the 10 s, which are five sixths of the time.
  EXPECT_EQ(budget.replacements(0, 7, {100, 2, 5}), 500u);
  EXPECT_EQ(budget.replacements(0, 7, {100, 0, 5}), 1'000'000'000'000'000u) << "no time at all";
  // 100 trials took 2 s of the 30 s.
  EXPECT_EQ(budget.replacements(1, 7, {100, 14, 20}), 1500u);
  EXPECT_EQ(budget.replacements(1, 7, {100, 11, 20}), 1'000'000'000'000'000u)
      << "the first region took less than it may";
}

/// The run may end before improving does.
TEST(ImprovingBudget, TheRunsEndCountsToo) {
  const Canvas canvas = two_regions();
  const CollageSettings late = improving(0, 48, 9);  // at 5 s of the run, 2 s of them improving: 6 s in all
  EXPECT_EQ(ImprovingBudget(canvas, late).replacements(0, 7, {100, 2, 5}), 250u);
  const CollageSettings early = improving(0, 48, 100);
  EXPECT_EQ(ImprovingBudget(canvas, early).replacements(0, 7, {100, 2, 5}), 500u);
  const CollageSettings over = improving(0, 48, 1);
  EXPECT_EQ(ImprovingBudget(canvas, over).replacements(0, 7, {100, 2, 5}), 0u);
}

}  // namespace test_improving_budget
}  // namespace tessera::master
