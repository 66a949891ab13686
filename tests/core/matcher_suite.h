// The contract of every Matcher, for all implementations. Include it in one file of a test binary, and instantiate MatcherSuite with the
// kinds to test.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <set>
#include <string>

#include "core/matching/colour_fit.h"
#include "core/matching/composite_matcher.h"
#include "core/matching/match_round.h"
#include "core/matching/reference_matcher.h"
#include "core/matching/refinement.h"
#include "support/matcher_round.h"

namespace tessera::test {

struct MatcherKind {
  std::string name;
  std::function<std::unique_ptr<Matcher>(const MatchingContext&, std::uint32_t first_shape, std::vector<ShapeModel>)>
      make;
};

inline std::ostream& operator<<(std::ostream& out, const MatcherKind& kind) { return out << kind.name; }

/// A scene and the reference's round on it, made once for all kinds.
struct KnownRound {
  explicit KnownRound(MatchingScene of, const StanceLimits& within = {}) : scene(std::move(of)), limits(within) {
    ReferenceMatcher reference(scene.context, 0, scene.models);
    set_field(reference, scene.field);
    if (limits != StanceLimits{}) reference.limit(limits);
    round = run_round(reference, scene);
  }

  MatchingScene scene;
  StanceLimits limits;
  Round round;
};

class MatcherSuite : public testing::TestWithParam<MatcherKind> {
 protected:
  static const MatchingScene& scene() {
    static const MatchingScene made = make_scene();
    return made;
  }

  /// A matcher with the whole library and the field of `scene`.
  std::unique_ptr<Matcher> matcher_of(const MatchingScene& scene) const {
    std::unique_ptr<Matcher> matcher = GetParam().make(scene.context, 0, scene.models);
    set_field(*matcher, scene.field);
    return matcher;
  }

  static ReferenceMatcher reference_of(const MatchingScene& scene) {
    ReferenceMatcher matcher(scene.context, 0, scene.models);
    set_field(matcher, scene.field);
    return matcher;
  }

  void expect_the_references_round(const KnownRound& known) const {
    const std::unique_ptr<Matcher> matcher = matcher_of(known.scene);
    if (known.limits != StanceLimits{}) matcher->limit(known.limits);
    EXPECT_FALSE(known.round.refined.empty());
    expect_same_round(run_round(*matcher, known.scene), known.round);
  }
};

TEST_P(MatcherSuite, KnowsItsShapes) {
  const auto matcher = GetParam().make(scene().context, 3, {scene().models.begin() + 3, scene().models.begin() + 7});
  EXPECT_EQ(matcher->shapes().begin, 3u);
  EXPECT_EQ(matcher->shapes().end, 7u);
}

TEST_P(MatcherSuite, GivesTheReferencesRound) {
  static const KnownRound known(scene());
  expect_the_references_round(known);
}

inline MatchingScene scene_with_other_settings() {
  CollageSettings settings = scene_settings();
  settings.seed = 77;
  settings.pieces.min_rotation_rad = -0.6f;
  settings.pieces.max_rotation_rad = 0.9f;
  settings.pieces.min_scale_px = 25;
  settings.match.pad = {4, 0.3f};
  settings.match.beta = 0.3f;
  return make_scene(settings, {6, 200, 2, 8});
}

TEST_P(MatcherSuite, GivesTheReferencesRoundWithOtherSettings) {
  static const KnownRound known(scene_with_other_settings());
  expect_the_references_round(known);
}

/// Rounds with one angle or hardly more, at any end of the interval, and some with hardly more than one scale.
inline std::vector<KnownRound> rounds_within_narrow_ranges() {
  std::vector<KnownRound> rounds;
  for (const float half_width_rad : {0.f, 0.002f, 0.1f}) {
    for (const float middle_rad : {0.f, 1.5707964f, -2.5f}) {
      CollageSettings settings = scene_settings();
      settings.pieces.min_rotation_rad = middle_rad - half_width_rad;
      settings.pieces.max_rotation_rad = middle_rad + half_width_rad;
      if (half_width_rad == 0.1f) settings.pieces.max_scale_px = settings.pieces.min_scale_px * 1.03f;
      rounds.emplace_back(make_scene(settings, {6, 200, 2, 8}));
    }
  }
  return rounds;
}

TEST_P(MatcherSuite, GivesTheReferencesRoundWithinNarrowRanges) {
  static const std::vector<KnownRound> rounds = rounds_within_narrow_ranges();
  for (const KnownRound& known : rounds) expect_the_references_round(known);
}

/// Three classes of shapes: quarter turns in two sizes; one that is weighted and nearly upright; one that may not stand in the second
/// region.
/// The limits of a round take some of it away.
inline MatchingScene scene_with_wishes() {
  CollageSettings settings = scene_settings();
  settings.pieces.several.rotation_rad = {{0, 0}, {1.5707964f, 1.5707964f}, {3.1415927f, 3.1415927f}, {-1.6f, -1.5f}};
  settings.pieces.several.scale_px = {{16, 20}, {40, 90}};
  settings.wishes.classes.resize(3);
  settings.wishes.classes[1].poses = {{{30, 60}}, {{-0.5f, 0.5f}}};
  settings.wishes.classes[1].weight = 0.05f;
  settings.wishes.classes[2].in_region = {1, 0};
  settings.wishes.class_of_shape = {0, 1, 2, 0, 1, 2, 0, 1, 2, 0};
  settings.wishes.regions.resize(2);
  settings.wishes.regions[1].poses.scale_px = {{16, 50}};
  return make_scene(settings);
}

TEST_P(MatcherSuite, GivesTheReferencesRoundWithWishes) {
  static const KnownRound known(scene_with_wishes());
  expect_the_references_round(known);
  const StanceTable& stances = known.scene.context.stances;
  std::set<std::uint32_t> stood;
  for (const RefinedDocking& refined : known.round.refined) {
    const StanceList& list = stances.list(refined.docking.shape);
    EXPECT_GE(refined.docking.stance, list.first);
    EXPECT_LT(refined.docking.stance, list.first + list.count);
    const PoseRange& poses = stances[refined.docking.stance].poses;
    EXPECT_TRUE(!refined.feasible || poses.contains(refined.docking.canvas_from_shape));
    stood.insert(refined.docking.stance);
  }
  EXPECT_GT(stood.size(), 7u) << "stances of all classes";
}

/// A target of many colours, with a hole where no colour is wished for.
inline MatchingScene scene_with_colours(float weight = 1) {
  CollageSettings settings = scene_settings();
  std::vector<Lab> of_shapes;
  for (std::uint32_t i = 0; i < 80; ++i) of_shapes.push_back(numbered_colour(i));
  settings.colour =
      wish_for(picture(260, 260,
                       [](Vec2 p) {
                         if (norm(p - Vec2{60, 60}) < 40) return Texel{};
                         return opaque(numbered_colour(std::uint32_t(p.x / 50) + 6 * std::uint32_t(p.y / 50)));
                       }),
               std::move(of_shapes), weight);
  return make_scene(settings, {.shapes = 80, .samples = 20});
}

TEST_P(MatcherSuite, GivesTheReferencesRoundWithColours) {
  static const KnownRound without(make_scene(scene_settings(), {.shapes = 80, .samples = 20}));
  static const KnownRound known(scene_with_colours());
  expect_the_references_round(without);
  expect_the_references_round(known);
  EXPECT_NE(known.round.histograms, without.round.histograms) << "pairs are of shapes with about the place's colour";
  int coloured = 0;
  for (const RefinedDocking& refined : known.round.refined) coloured += refined.terms.colour_difference > 0;
  EXPECT_GT(coloured, 20);
  const auto mean_difference = [](const Round& of) {
    double sum = 0;
    for (const Docking& d : of.docked.dockings) {
      sum += mean_colour_difference(known.scene.models[index_of(d.shape)].colour, d.canvas_from_shape,
                                    *known.scene.settings.colour.target);
    }
    return sum / double(of.docked.dockings.size());
  };
  EXPECT_LT(mean_difference(known.round), 0.8 * mean_difference(without.round))
      << "slots are spent on what has the colour";
}

inline StanceLimits every_third_of_80_used_up() {
  StanceLimits limits;
  for (std::uint32_t shape = 0; shape < 80; shape += 3) limits.used_up.push_back(ShapeId{shape});
  return limits;
}

TEST_P(MatcherSuite, GivesTheReferencesRoundWithColoursWithinLimits) {
  static const KnownRound known(scene_with_colours(0.3f), every_third_of_80_used_up());
  expect_the_references_round(known);
  for (const Docking& docking : known.round.docked.dockings) EXPECT_NE(index_of(docking.shape) % 3, 0u);
}

/// With this weight, most differences cost more than kEvenFading halvings.
TEST_P(MatcherSuite, GivesTheReferencesRoundWithHeavyColours) {
  static const KnownRound known(scene_with_colours(12));
  expect_the_references_round(known);
}

/// Matchers keep the order of shapes by colour under all limits, but not the list of shapes that may stand.
TEST_P(MatcherSuite, ColoursAfterOtherLimitsAreThoseOfTheLimits) {
  static const MatchingScene scene = scene_with_colours();
  StanceLimits limits;
  for (std::uint32_t shape = 0; shape < 40; ++shape) limits.used_up.push_back(ShapeId{shape});
  const auto matcher = matcher_of(scene), fresh = matcher_of(scene);
  const Round before = run_round(*matcher, scene);
  matcher->limit(limits);
  fresh->limit(limits);
  expect_same_round(run_round(*matcher, scene), run_round(*fresh, scene));
  matcher->limit({});
  expect_same_round(run_round(*matcher, scene), before);
}

/// Sizes by place: only small pieces on the left, all sizes on the right.
inline MatchingScene scene_with_sizes_by_place() {
  CollageSettings settings = scene_settings();
  SizeMap map{Grid<float>(13, 13), 0.05f};
  for (int i = 0; i < 13; ++i) {
    for (int j = 0; j < 13; ++j) map.part(i, j) = float(i) / 11;
  }
  settings.pieces.size_map = std::make_shared<const SizeMap>(map);
  return make_scene(settings);
}

TEST_P(MatcherSuite, GivesTheReferencesRoundWithSizesByPlace) {
  static const KnownRound known(scene_with_sizes_by_place());
  expect_the_references_round(known);
  const SizeMap& map = *known.scene.settings.pieces.size_map;
  bool large = false;
  for (std::size_t i = 0; i < known.round.refined.size(); ++i) {
    const RefinedDocking& refined = known.round.refined[i];
    if (!refined.feasible) continue;
    const Similarity& before = known.round.docked.dockings[i].canvas_from_shape;
    const float most_px = 16 * std::exp2(std::min(1.f, map.at(before.translation())) * std::log2(90.f / 16));
    EXPECT_LE(refined.docking.canvas_from_shape.scale(), most_px * 1.001f);
    large = large || refined.docking.canvas_from_shape.scale() > 60;
  }
  EXPECT_TRUE(large) << "where it is white";
}

TEST_P(MatcherSuite, GivesTheReferencesRoundWithinLimits) {
  static const KnownRound known(scene_with_wishes(), {1, 0.9f, 45, {ShapeId{0}, ShapeId{4}, ShapeId{6}}});
  expect_the_references_round(known);
  const StanceTable stances = known.scene.context.stances.limited(known.limits);
  for (const Docking& docking : known.round.docked.dockings) {
    EXPECT_GT(stances.list(docking.shape).count, 0u) << index_of(docking.shape);
    EXPECT_LE(docking.canvas_from_shape.scale(), 45.01f);
  }
}

/// A job that searches for sizes. It goes down to sizes at which targets are smoothed as little as possible and other levels are used.
inline MatchingScene scene_that_fits_all() {
  CollageSettings settings = scene_settings();
  settings.pieces.min_scale_px = 4 * settings.pieces.min_scale_px;
  settings.pieces.max_scale_px = 4 * settings.pieces.max_scale_px;
  settings.pieces.fit_all = true;
  MatchingScene scene = make_scene(settings);
  const MatchingScene smaller = make_scene();  // its field and samples
  scene.field = smaller.field;
  scene.samples = smaller.samples;
  return scene;
}

inline StanceLimits size_factor(float factor) {
  StanceLimits limits;
  limits.size_factor = factor;
  return limits;
}

TEST_P(MatcherSuite, GivesTheReferencesRoundAtASmallerFactor) {
  static const KnownRound quarter(scene_that_fits_all(), size_factor(0.25f));
  static const KnownRound least(scene_that_fits_all(), size_factor(0.06f));
  expect_the_references_round(quarter);
  expect_the_references_round(least);
}

/// Only the numbers of the PADs differ, because other levels precede them.
TEST_P(MatcherSuite, AFactorIsAsIfTheJobHadTheseSizes) {
  static const MatchingScene scene = scene_that_fits_all();
  const auto sized = matcher_of(scene);
  sized->limit(size_factor(0.25f));
  const auto plain = matcher_of(MatcherSuite::scene());
  Round found = run_round(*sized, MatcherSuite::scene());
  const Round expected = run_round(*plain, MatcherSuite::scene());
  ASSERT_EQ(found.docked.dockings.size(), expected.docked.dockings.size());
  for (std::size_t i = 0; i < expected.docked.dockings.size(); ++i) {
    Docking& docking = found.docked.dockings[i];
    if (docking.source < kTangentSource) docking.source = expected.docked.dockings[i].source;
    EXPECT_EQ(docking.canvas_from_shape, expected.docked.dockings[i].canvas_from_shape) << i;
    EXPECT_EQ(docking.key, expected.docked.dockings[i].key) << i;
  }
}

/// Pairs that were found before the limits must not come back.
TEST_P(MatcherSuite, LimitsHoldFromThenOnAndMayBeTakenBack) {
  const auto matcher = matcher_of(scene());
  const Round before = run_round(*matcher, scene());
  const ShapeId often = before.docked.dockings.front().shape;
  matcher->limit({0, 1, 30, {often}});
  const Round limited = run_round(*matcher, scene());
  EXPECT_FALSE(limited.docked.dockings.empty());
  for (const Docking& docking : limited.docked.dockings) {
    EXPECT_NE(docking.shape, often);
    EXPECT_LE(docking.canvas_from_shape.scale(), 30.01f);
  }
  matcher->limit({});
  expect_same_round(run_round(*matcher, scene()), before);
}

TEST_P(MatcherSuite, WhereNothingMayStandNothingDocks) {
  const auto matcher = matcher_of(scene());
  matcher->limit({0, 1, 1, {}});
  const Round round = run_round(*matcher, scene());
  EXPECT_TRUE(round.docked.dockings.empty());
  EXPECT_EQ(round.docked.evaluated, 0u);
}

TEST_P(MatcherSuite, FindsDockingsOfBothKinds) {
  const auto matcher = matcher_of(scene());
  const Round round = run_round(*matcher, scene());
  std::size_t pads = 0;
  for (const Docking& docking : round.docked.dockings) pads += docking.source < kTangentSource;
  EXPECT_GT(pads, 10u);
  EXPECT_GT(round.docked.dockings.size(), pads + 10);
  EXPECT_GE(round.docked.evaluated, round.docked.dockings.size());
}

TEST_P(MatcherSuite, ShortlistsAreShortAndInOrder) {
  const auto matcher = matcher_of(scene());
  const std::vector<Docking> dockings = run_round(*matcher, scene()).docked.dockings;
  ASSERT_FALSE(dockings.empty());
  std::vector<int> of_sample(scene().samples.size());
  for (std::size_t i = 0; i < dockings.size(); ++i) {
    ASSERT_LT(dockings[i].sample, of_sample.size());
    EXPECT_LE(++of_sample[dockings[i].sample], kShortlist);
    EXPECT_GE(dockings[i].key, kLeastDockingKey);
    EXPECT_LT(index_of(dockings[i].shape), scene().models.size());
    if (i == 0) continue;
    const Docking& before = dockings[i - 1];
    EXPECT_TRUE(before.sample < dockings[i].sample ||
                (before.sample == dockings[i].sample && docks_better(before, dockings[i])));
  }
}

TEST_P(MatcherSuite, BinLimitsAndDrawsChooseTheKindOfDocking) {
  const auto matcher = matcher_of(scene());
  DockRequest request{scene().samples, std::vector<std::uint32_t>(scene().samples.size(), 0), 60};
  matcher->post_dock(request);
  for (const Docking& docking : matcher->take_dock().dockings) EXPECT_GE(docking.source, kTangentSource);
  request.tangent_dockings = 0;
  matcher->post_dock(request);
  const DockReply nothing = matcher->take_dock();
  EXPECT_TRUE(nothing.dockings.empty());
  EXPECT_EQ(nothing.evaluated, 0u);
  request.bin_limit.assign(scene().samples.size(), kDistanceBins);
  matcher->post_dock(request);
  const DockReply pads = matcher->take_dock();
  EXPECT_FALSE(pads.dockings.empty());
  for (const Docking& docking : pads.dockings) EXPECT_LT(docking.source, kTangentSource);
}

/// The first draws are kept instead of the best ones, whatever the order in which a device finds them.
TEST_P(MatcherSuite, KeepsTheFirstDrawnWhereTheseAreWanted) {
  const auto matcher = matcher_of(scene());
  ReferenceMatcher reference = reference_of(scene());
  DockRequest request{scene().samples, std::vector<std::uint32_t>(scene().samples.size(), 0), 400};
  matcher->post_dock(request);
  const std::vector<Docking> best = matcher->take_dock().dockings;
  request.first_drawn = true;
  matcher->post_dock(request);
  const std::vector<Docking> first = matcher->take_dock().dockings;
  reference.post_dock(request);
  test::expect_same_dockings(first, reference.take_dock().dockings);
  ASSERT_EQ(first.size(), best.size());
  bool other = false;
  for (std::size_t i = 0; i < first.size(); ++i) {
    other |= first[i].source != best[i].source;
    if (i == 0 || first[i].sample != first[i - 1].sample) continue;
    EXPECT_LT(first[i - 1].source, first[i].source);
  }
  EXPECT_TRUE(other);
  for (const Docking& docking : best) {  // no earlier draw than the last one kept was left out
    const auto of_sample = [&](const Docking& d) { return d.sample == docking.sample; };
    const auto last = std::find_if(first.rbegin(), first.rend(), of_sample);
    ASSERT_NE(last, first.rend());
    const bool kept = std::any_of(first.begin(), first.end(),
                                  [&](const Docking& d) { return of_sample(d) && d.source == docking.source; });
    EXPECT_TRUE(kept || docking.source > last->source);
  }
}

TEST_P(MatcherSuite, ADrawPutsItsBoundaryPointOnTheSample) {
  const auto matcher = matcher_of(scene());
  matcher->post_dock({scene().samples, std::vector<std::uint32_t>(scene().samples.size(), 0), 60});
  const std::vector<Docking> dockings = matcher->take_dock().dockings;
  ASSERT_FALSE(dockings.empty());
  for (const Docking& docking : dockings) {
    const TargetSample& sample = scene().samples[docking.sample];
    const TangentDraw draw = draw_tangent(scene().context, sample, docking.source - kTangentSource);
    EXPECT_EQ(draw.shape, docking.shape);
    const Vec2 point = docking.canvas_from_shape.apply(scene().models[index_of(draw.shape)].boundary[docked_point(
        scene().models[index_of(draw.shape)], draw, sample, scene().context.stances[draw.stance].docked_rotations)]);
    EXPECT_LT(norm(point - sample.position), 0.01f);
  }
}

TEST_P(MatcherSuite, DocksTheSameWithOrWithoutCounting) {
  const std::vector<TargetSample> others(scene().samples.begin() + 2, scene().samples.begin() + 7);
  const DockRequest request{others, std::vector<std::uint32_t>(others.size(), kDistanceBins / 2), 20};
  const auto fresh = matcher_of(scene());
  fresh->post_dock(request);
  const std::vector<Docking> expected = fresh->take_dock().dockings;
  EXPECT_FALSE(expected.empty());
  for (const std::vector<TargetSample>& counted : {others, scene().samples}) {
    const auto matcher = matcher_of(scene());
    matcher->post_count(count_all(counted));
    matcher->take_count();
    matcher->post_dock(request);
    EXPECT_EQ(matcher->take_dock().dockings, expected);
  }
}

/// Asks for long distances, then for shorter ones. A matcher may reuse its counts, but may not count beyond the question. Some samples are
/// left out.
TEST_P(MatcherSuite, CountsAsFarAsItIsAsked) {
  const auto matcher = matcher_of(scene());
  ReferenceMatcher reference = reference_of(scene());
  reference.post_count(count_all(scene().samples));
  const std::vector<DistanceHistogram> all = reference.take_count();
  std::size_t ended = 0;
  std::vector<TargetSample> samples = scene().samples;  // sent only once
  for (const std::uint32_t far : {7u, 2u, 25u, 1u, 60u, 11u}) {
    CountRequest request{std::exchange(samples, {}), {}};
    std::vector<DistanceHistogram> expected;
    for (std::uint32_t t = 0; t < all.size(); ++t) {
      request.bins.push_back(t % 3 == far % 3 ? 0 : far + t % 4);
      if (request.bins.back() == 0) continue;
      expected.push_back(all[t]);
      std::fill(expected.back().begin() + request.bins.back(), expected.back().end(), 0);
      ended += expected.back() != all[t];
    }
    matcher->post_count(request);
    EXPECT_EQ(matcher->take_count(), expected) << far << " bins";
  }
  EXPECT_GT(ended, all.size());
  expect_same_round(run_round(*matcher, scene()), run_round(reference, scene()));
}

TEST_P(MatcherSuite, ANewPassDrawsAnew) {
  const auto matcher = matcher_of(scene());
  DockRequest request{scene().samples, std::vector<std::uint32_t>(scene().samples.size(), 0), 60};
  matcher->post_dock(request);
  const std::vector<Docking> first = matcher->take_dock().dockings;
  for (TargetSample& sample : request.samples) ++sample.pass;
  matcher->post_dock(request);
  EXPECT_NE(matcher->take_dock().dockings, first);
}

TEST_P(MatcherSuite, RefinedDockingsKeepTheirOrderAndAreFeasible) {
  const auto matcher = matcher_of(scene());
  const Round round = run_round(*matcher, scene());
  ASSERT_EQ(round.refined.size(), round.docked.dockings.size());
  const PieceSettings& pieces = scene().settings.pieces;
  int feasible = 0;
  for (std::size_t i = 0; i < round.refined.size(); ++i) {
    const RefinedDocking& refined = round.refined[i];
    EXPECT_EQ(refined.docking.shape, round.docked.dockings[i].shape);
    EXPECT_EQ(refined.docking.source, round.docked.dockings[i].source);
    if (!refined.feasible) continue;
    ++feasible;
    const Similarity& pose = refined.docking.canvas_from_shape;
    EXPECT_LE(depth_px(pose, scene().models[index_of(refined.docking.shape)], FieldView(scene().field)),
              scene().context.hard_depth_px + 1e-3f);
    EXPECT_GE(pose.scale(), pieces.min_scale_px * 0.999f);
    EXPECT_LE(pose.scale(), pieces.max_scale_px * 1.001f);
    EXPECT_GE(refined.terms.matched_px, 0);
    const ShapeModel& model = scene().models[index_of(refined.docking.shape)];
    EXPECT_EQ(refined.extent, extent_of(model.boundary, pose));
    EXPECT_EQ(refined.perimeter, model.perimeter);
    EXPECT_EQ(refined.radius, model.radius);
  }
  EXPECT_GT(feasible, 20);
}

/// Measuring a refined docking on the unchanged field gives the terms of its refinement; on a covered field it gives others.
TEST_P(MatcherSuite, MeasuresDockingsOnTheFieldAsItIs) {
  const auto matcher = matcher_of(scene());
  std::vector<Docking> dockings;
  std::vector<DockingTerms> expected;
  for (const RefinedDocking& refined : run_round(*matcher, scene()).refined) {
    if (!refined.feasible) continue;
    dockings.push_back(refined.docking);
    expected.push_back(refined.terms);
  }
  ASSERT_GT(dockings.size(), 20u);
  matcher->post_measure(dockings);
  EXPECT_EQ(matcher->take_measure(), expected);
  const Grid<float> covered(scene().field.value.width(), scene().field.value.height(), -50.f);
  matcher->update_field({read_patch(covered, covered.bounds())});
  matcher->post_measure(dockings);
  for (const DockingTerms& terms : matcher->take_measure()) EXPECT_GT(terms.overlap_px2, 0);
}

TEST_P(MatcherSuite, SeesWhatIsWrittenIntoTheField) {
  const auto matcher = matcher_of(scene());
  const Round before = run_round(*matcher, scene());
  const Grid<float> covered(scene().field.value.width(), scene().field.value.height(), -50.f);
  matcher->update_field({read_patch(covered, covered.bounds())});
  EXPECT_TRUE(run_round(*matcher, scene()).docked.dockings.empty());
  const int middle = covered.height() / 3;  // the field comes back in two parts
  matcher->update_field({read_patch(scene().field.value, {0, 0, covered.width(), middle})});
  matcher->update_field({read_patch(scene().field.value, {0, middle, covered.width(), covered.height()})});
  expect_same_round(run_round(*matcher, scene()), before);
}

TEST_P(MatcherSuite, AFieldMayBeStartedAgain) {
  const auto matcher = GetParam().make(scene().context, 0, scene().models);
  set_field(*matcher, {Grid<float>(40, 30, -1.f), {}});
  EXPECT_TRUE(run_round(*matcher, scene()).docked.dockings.empty());
  set_field(*matcher, scene().field);
  ReferenceMatcher reference = reference_of(scene());
  expect_same_round(run_round(*matcher, scene()), run_round(reference, scene()));
}

TEST_P(MatcherSuite, PartsGiveTheAnswersOfTheWhole) {
  const std::vector<ShapeModel>& models = scene().models;
  std::vector<std::unique_ptr<Matcher>> parts;
  parts.push_back(GetParam().make(scene().context, 0, {models.begin(), models.begin() + 3}));
  parts.push_back(GetParam().make(scene().context, 3, {models.begin() + 3, models.end()}));
  CompositeMatcher divided(std::move(parts));
  set_field(divided, scene().field);
  const auto whole = matcher_of(scene());
  expect_same_round(run_round(divided, scene()), run_round(*whole, scene()));
}

TEST_P(MatcherSuite, NoShapesGiveNoDockings) {
  const auto matcher = GetParam().make(scene().context, 4, {});
  set_field(*matcher, scene().field);
  EXPECT_EQ(matcher->shapes().begin, matcher->shapes().end);
  const Round round = run_round(*matcher, scene());
  for (const DistanceHistogram& histogram : round.histograms) EXPECT_EQ(histogram, DistanceHistogram{});
  EXPECT_EQ(round.histograms.size(), scene().samples.size());
  EXPECT_TRUE(round.docked.dockings.empty());
  EXPECT_EQ(round.docked.evaluated, 0u);
}

TEST_P(MatcherSuite, EmptyRequestsGiveEmptyReplies) {
  const auto matcher = matcher_of(scene());
  matcher->post_count({{}, {}});
  EXPECT_TRUE(matcher->take_count().empty());
  matcher->post_dock({{}, {}, 60});
  EXPECT_TRUE(matcher->take_dock().dockings.empty());
  matcher->post_refine({});
  EXPECT_TRUE(matcher->take_refine().empty());
  matcher->post_measure({});
  EXPECT_TRUE(matcher->take_measure().empty());
}

}  // namespace tessera::test
