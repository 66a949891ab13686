// The paper's choice of pairs, as a matcher.
#include "bench/baselines/paper_matcher.h"

#include <gtest/gtest.h>

#include "core/collage/objective.h"
#include "support/matcher_round.h"

namespace tessera::bench {
namespace test_paper_matcher {

test::MatchingScene paper_scene() { return test::make_scene(paper_settings(test::scene_settings())); }

TEST(PaperMatcher, DocksPairsBelowTheLimitAndLeavesThemAsTheyAre) {
  const test::MatchingScene scene = paper_scene();
  PaperMatcher matcher(scene.settings, scene.context, scene.models);
  test::set_field(matcher, scene.field);
  const test::Round round = test::run_round(matcher, scene);
  EXPECT_GT(round.docked.evaluated, 0u);
  ASSERT_EQ(round.refined.size(), round.docked.dockings.size());
  ASSERT_FALSE(round.refined.empty());
  for (std::size_t i = 0; i < round.refined.size(); ++i) {
    EXPECT_EQ(round.refined[i].docking, round.docked.dockings[i]);
    EXPECT_TRUE(round.refined[i].feasible);
    const float scale = round.refined[i].docking.canvas_from_shape.scale();
    EXPECT_GE(scale, scene.settings.pieces.min_scale_px);
    EXPECT_LE(scale, scene.context.max_scale_px);
  }
}

TEST(PaperMatcher, CountsEveryPairBelowBeta) {
  const test::MatchingScene scene = paper_scene();
  PaperMatcher matcher(scene.settings, scene.context, scene.models);
  matcher.post_count(test::count_all(scene.samples));
  const std::vector<DistanceHistogram> histograms = matcher.take_count();
  ASSERT_EQ(histograms.size(), scene.samples.size());
  std::uint64_t expected = 0;
  const int levels = scene.context.pad.levels;
  Pad target = make_pad(scene.samples[0].pyramid, levels);
  for (const ShapeModel& model : scene.models) {
    for (const ModelLevel& level : model.levels) {
      for (const ModelSample& sample : level.samples) {
        Pad pad{.element = {}, .convexity = sample.convexity};
        for (int e = 0; e < kMaxPadElements; ++e) pad.element[e] = float(sample.pad.element[e]) / float(kPadSteps);
        expected += pad_distance(target, pad, levels) < scene.settings.match.beta;
      }
    }
  }
  std::uint64_t found = 0;
  for (const std::uint32_t pairs : histograms[0]) found += pairs;
  EXPECT_EQ(found, expected);
}

TEST(PaperMatcher, RanksByTheObjective) {
  const test::MatchingScene scene = paper_scene();
  PaperMatcher matcher(scene.settings, scene.context, scene.models);
  test::set_field(matcher, scene.field);
  for (const RefinedDocking& found : test::run_round(matcher, scene).refined) {
    const float scale = found.docking.canvas_from_shape.scale();
    const float perimeter_px = scene.models[index_of(found.docking.shape)].perimeter * scale;
    EXPECT_EQ(found.docking.key,
              objective(found.terms, {scale, perimeter_px, scene.context.max_scale_px}, scene.settings.objective));
  }
}

}  // namespace test_paper_matcher
}  // namespace tessera::bench
