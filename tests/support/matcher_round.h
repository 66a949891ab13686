// One round of questions to a Matcher, and the comparison of two matchers' answers.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "core/matching/matcher.h"
#include "support/matching_scene.h"

namespace tessera::test {

inline void set_field(Matcher& matcher, const CanvasField& field) {
  matcher.start_field(field.value.width(), field.value.height(), field.origin);
  matcher.update_field({read_patch(field.value, field.value.bounds())});
}

struct Round {
  std::vector<DistanceHistogram> histograms;
  DockReply docked;
  std::vector<RefinedDocking> refined;  // of all dockings
  std::vector<DockingTerms> measured;   // of all dockings, in the poses of the dock reply
};

inline CountRequest count_all(const std::vector<TargetSample>& samples) {
  return {samples, std::vector<std::uint32_t>(samples.size(), kDistanceBins)};
}

/// Takes the pairs below the bin at which a fiftieth of all PADs is counted, as the master does.
inline Round run_round(Matcher& matcher, const MatchingScene& scene) {
  Round round;
  matcher.post_count(count_all(scene.samples));
  round.histograms = matcher.take_count();
  std::size_t pads = 0;
  for (const ShapeModel& model : scene.models) {
    for (const ModelLevel& level : model.levels) pads += level.samples.size();
  }
  DockRequest request{scene.samples, {}, std::uint32_t(scene.settings.match.tangent_dockings)};
  for (const DistanceHistogram& histogram : round.histograms) {
    request.bin_limit.push_back(bin_limit_for(histogram, pads / 50));
  }
  matcher.post_dock(request);
  round.docked = matcher.take_dock();
  matcher.post_refine(round.docked.dockings);
  round.refined = matcher.take_refine();
  matcher.post_measure(round.docked.dockings);
  round.measured = matcher.take_measure();
  return round;
}

inline float difference(const Similarity& a, const Similarity& b) {
  return std::max(std::max(std::abs(a.a - b.a), std::abs(a.b - b.b)),
                  std::max(std::abs(a.tx - b.tx), std::abs(a.ty - b.ty)));
}

/// Expects the same bits, or small differences on a device that cannot give the same bits.
inline void expect_same_dockings(const std::vector<Docking>& found, const std::vector<Docking>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  std::size_t differing = 0;
  float key = 0;
  float pose = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    differing += found[i] != expected[i];
    key = std::max(key, std::abs(found[i].key - expected[i].key));
    pose = std::max(pose, difference(found[i].canvas_from_shape, expected[i].canvas_from_shape));
  }
  EXPECT_EQ(differing, 0u) << "of " << found.size() << " dockings; keys differ by up to " << key << ", poses by "
                           << pose;
}

inline void expect_same_refined(const std::vector<RefinedDocking>& found, const std::vector<RefinedDocking>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  std::size_t differing = 0;
  std::size_t feasibility = 0;
  float pose = 0;
  float matched_px = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    differing += found[i] != expected[i];
    feasibility += found[i].feasible != expected[i].feasible;
    pose = std::max(pose, difference(found[i].docking.canvas_from_shape, expected[i].docking.canvas_from_shape));
    matched_px = std::max(matched_px, std::abs(found[i].terms.matched_px - expected[i].terms.matched_px));
  }
  EXPECT_EQ(differing, 0u) << "of " << found.size() << " refined dockings; " << feasibility
                           << " in feasibility, poses by up to " << pose << ", matched lengths by " << matched_px
                           << " px";
}

inline void expect_same_round(const Round& found, const Round& expected) {
  EXPECT_EQ(found.histograms, expected.histograms);
  EXPECT_EQ(found.docked.evaluated, expected.docked.evaluated);
  expect_same_dockings(found.docked.dockings, expected.docked.dockings);
  expect_same_refined(found.refined, expected.refined);
  EXPECT_EQ(found.measured.size(), expected.measured.size());
  EXPECT_TRUE(found.measured == expected.measured);
}

}  // namespace tessera::test
