// Whole collages on repeating canvases.
#include <gtest/gtest.h>

#include <set>

#include "core/base/stop.h"
#include "core/collage/placed_outlines.h"
#include "core/settings/tuning.h"
#include "master/filling.h"
#include "master/improving.h"
#include "offering_matcher.h"
#include "stopped_collage.h"
#include "support/polygon_distance.h"
#include "support/synthetic_shapes.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_seamless {

using namespace whole_collage;

const Canvas& both_ways() {
  static const Canvas canvas = make_seamless_canvas(240, 180, true, true);
  return canvas;
}

Outline outline_at(const Placement& placement, Vec2 offset) {
  return placed_outline(library()[index_of(placement.shape)].outline, moved(placement.canvas_from_shape, offset));
}

float radius_px(const Placement& placement) {
  return library()[index_of(placement.shape)].radius * placement.canvas_from_shape.scale();
}

/// Calls f(piece, image) for each pair that may touch: pieces in their places, and images of all pieces.
template <class F>
void each_neighbours(const Canvas& canvas, const std::vector<Placement>& placements, F f) {
  for (std::size_t i = 0; i < placements.size(); ++i) {
    for (std::size_t k = 0; k < placements.size(); ++k) {
      for (const Vec2 offset : canvas.period.offsets()) {
        if (i == k && offset == Vec2{}) continue;
        const Vec2 apart =
            placements[i].canvas_from_shape.translation() - placements[k].canvas_from_shape.translation() - offset;
        if (norm(apart) > radius_px(placements[i]) + radius_px(placements[k]) + 8) continue;
        f(outline_at(placements[i], {}), outline_at(placements[k], offset));
      }
    }
  }
}

std::size_t crossing_seams(const Canvas& canvas, const std::vector<Placement>& placements) {
  return std::size_t(std::count_if(placements.begin(), placements.end(), [&](const Placement& p) {
    const Box box = bounding_box(outline_at(p, {}).curves.front());
    return (canvas.period.x_px > 0 && (box.low.x < 0 || box.high.x > float(canvas.width_px))) ||
           (canvas.period.y_px > 0 && (box.low.y < 0 || box.high.y > float(canvas.height_px)));
  }));
}

TEST(Seamless, FillsThePeriodAcrossItsEdges) {
  for (const auto& [in_x, in_y] : {std::pair(true, false), std::pair(false, true), std::pair(true, true)}) {
    const Canvas canvas = make_seamless_canvas(240, 180, in_x, in_y);
    const CollageResult result = run(canvas, settings());
    const Quality q = quality(canvas, result);
    EXPECT_GT(q.coverage, 0.78);
    EXPECT_LT(q.overlap, 0.006);
    EXPECT_LT(q.outside, 0.001);
    EXPECT_GT(q.shared_boundary, 0.4);
    EXPECT_EQ(result.statistics.stopped_by, StopReason::full);
    EXPECT_GE(crossing_seams(canvas, result.placements), in_x && in_y ? 4u : 2u);
    for (const Placement& p : result.placements) {
      EXPECT_EQ(canvas.period.wrapped(p.canvas_from_shape), p.canvas_from_shape);
    }
  }
}

TEST(Seamless, KeepsThePaddingAcrossTheSeams) {
  for (const float padding_px : {1.f, 4.f}) {
    CollageSettings s = settings();
    s.pieces.padding_px = padding_px;
    const std::vector<Placement> placements = run(both_ways(), s).placements;
    EXPECT_GT(crossing_seams(both_ways(), placements), 2u);
    double least = 1e9;
    each_neighbours(both_ways(), placements,
                    [&](const Outline& a, const Outline& b) { least = std::min(least, test::polygon_distance(a, b)); });
    EXPECT_GE(least, padding_px);
  }
}

TEST(Seamless, NoVertexLiesDeepInAnImageOfAPiece) {
  float deepest = 0;
  each_neighbours(both_ways(), run(both_ways(), settings()).placements, [&](const Outline& a, const Outline& b) {
    for (const Vec2 p : a.curves[0]) deepest = std::max(deepest, -test::signed_distance(b, p));
  });
  EXPECT_LE(deepest, PieceSettings().overlap_px + 0.01f);
}

/// On an endless plane most larger pieces would reach their own images.
TEST(Seamless, NoPieceIsAsLongAsThePeriod) {
  const Canvas canvas = make_seamless_canvas(70, 60, true, true);
  CollageSettings s = settings();
  s.pieces.min_scale_px = 12;
  const CollageResult result = run(canvas, s);
  EXPECT_GT(result.placements.size(), 2u);
  for (const Placement& p : result.placements) {
    const Box box = bounding_box(outline_at(p, {}).curves.front());
    EXPECT_LE(box.width(), 70 + PieceSettings().overlap_px);
    EXPECT_LE(box.height(), 60 + PieceSettings().overlap_px);
  }
  const Quality q = quality(canvas, result);
  EXPECT_LT(q.overlap, 0.02);
  EXPECT_GT(q.coverage, 0.6);
}

/// This also holds without settling, which would give up such candidates.
TEST(Seamless, CandidatesThatAreAsLongAsThePeriodAreNone) {
  const Canvas canvas = make_seamless_canvas(90, 60, false, true);
  CollageSettings s = settings();
  s.settle = false;
  const std::vector<Placement> placements = run(canvas, s).placements;
  EXPECT_GT(placements.size(), 2u);
  for (const Placement& p : placements) EXPECT_LE(bounding_box(outline_at(p, {}).curves.front()).height(), 61);
}

/// The field as the workers know it.
class FieldMatcher : public test::OfferingMatcher {
 public:
  using OfferingMatcher::OfferingMatcher;
  Grid<float> field;

  void start_field(int width, int height, Vec2) override { field = Grid<float>(width, height); }
  void update_field(const std::vector<FieldPatch>& patches) override { write_patches(patches, field); }
};

TEST(Seamless, WorkersGetAllImagesOfAPiece) {
  CollageSettings s = settings();
  s.settle = false;
  const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
  test::VectorShapes shapes(library());
  Collage collage(make_seamless_canvas(240, 220, true, true), s, context, shapes);
  FieldMatcher matcher(library());
  RunStatistics statistics;
  Filling filling(collage, context, s, matcher, statistics);
  matcher.offers = {test::piece(3, 40, {238, 5}), test::piece(4, 40, {4, 90}), test::piece(5, 40, {120, 218})};
  while (filling.place_one()) {
    filling.end_batch();
    EXPECT_EQ(matcher.field.data(), collage.free().field().value.data());
  }
  EXPECT_EQ(collage.placements().size(), 4u) << "the first piece, and those that are offered";
}

/// The canvas that repeats both ways, with all objects for a collage on it.
struct Scene {
  explicit Scene(const CollageSettings& s = settings(), const Canvas& canvas = both_ways())
      : context(make_matching_context(s, std::uint32_t(library().size()))),
        collage(canvas, s, context, shapes),
        filling(collage, context, s, matcher, statistics) {}

  MatchingContext context;
  test::VectorShapes shapes{library()};
  Collage collage;
  test::OfferingMatcher matcher{library()};
  RunStatistics statistics;
  Filling filling;
};

TEST(Seamless, AWindowAcrossASeamMarksTheSamplesOnBothSides) {
  Scene scene;
  Collage& collage = scene.collage;
  collage.replace_placements({test::piece(3, 60, {0, 90})});
  collage.schedule().take();
  const Window& nodes = collage.free().grid().one_period();
  collage.schedule().mark({nodes.x0 - 20, nodes.y0, nodes.x0 + 20, nodes.y1});
  bool left = false;
  bool right = false;
  for (const TargetSample& sample : collage.schedule().take()) {
    left |= sample.position.x <= 21;
    right |= sample.position.x >= 219;
    EXPECT_TRUE(sample.position.x <= 21 || sample.position.x >= 219) << sample.position.x;
  }
  EXPECT_TRUE(left && right);
}

/// The placed piece pushes the next one to the left, across the seam.
TEST(Seamless, APieceThatIsPushedAcrossASeamComesInAtTheOtherSide) {
  const Canvas canvas = make_seamless_canvas(240, 220, true, true);
  const auto settled_at = [&](float standing_px, float offered_px) {
    Scene scene(settings(), canvas);
    scene.collage.replace_placements({test::piece(3, 60, {standing_px, 100})});
    scene.collage.schedule().mark(scene.collage.free().grid().nodes());
    scene.matcher.offers = {test::piece(5, 60, {offered_px, 100})};
    EXPECT_TRUE(scene.filling.place_one());
    return scene.collage.placements().back().canvas_from_shape.tx;
  };
  const float settled_px = settled_at(160, 102);
  ASSERT_LT(settled_px, 101.5f) << "the test needs a piece that is pushed to the left";
  EXPECT_NEAR(settled_at(58.1f, 0.1f), settled_px - 101.9f + 240, 0.2);
}

TEST(Seamless, PiecesOnBothSidesOfASeamAreTakenOutTogether) {
  const Canvas canvas = make_seamless_canvas(400, 60, true, true);
  Scene scene(settings(), canvas);
  std::vector<Placement> row;
  for (int i = 0; i < 20; ++i) row.push_back(test::piece(3, 14, {float(20 * i + 2), 30}));
  scene.collage.replace_placements(row);
  Improving improving(scene.collage, scene.filling, settings(), canvas.area_px2, scene.shapes);
  bool across = false;
  for (std::uint32_t trial = 0; trial < 60; ++trial) {
    const StopCheck look_and_stop = [&] {
      const std::vector<Placement>& left = scene.collage.placements();
      across |= std::find(left.begin(), left.end(), row.front()) == left.end() &&
                std::find(left.begin(), left.end(), row.back()) == left.end();
      throw Interrupted{StopReason::signal};
    };
    EXPECT_THROW(improving.try_once(trial, look_and_stop), Interrupted);
  }
  EXPECT_TRUE(across);
}

/// Areas computed ahead are forgotten if a piece changes them from the other side of a seam.
TEST(Seamless, ExactAreasAreThoseOfTheFieldAsItIs) {
  const PieceSettings pieces = settings().pieces;
  FreeField free(both_ways(), pieces);
  OpenedField opened(free, pieces);
  test::VectorShapes shapes(library());
  const MatchingContext context = make_matching_context(settings(), std::uint32_t(library().size()));
  const PlacedOutlines outlines(free, pieces);
  const Settling settling(free, outlines, context);
  PieceChecks checks(shapes, free, opened, settling, pieces, context);
  Candidate candidate;
  candidate.shape = ShapeId{3};
  candidate.canvas_from_shape = {60, 0, 10, 90};
  checks.compute_areas_ahead({candidate});
  EXPECT_EQ(checks.areas(candidate).overlap_px2, 0);
  checks.forget(opened.update(free, {free.stamp(library()[4], {60, 0, 225, 90})}).front());
  EXPECT_GT(checks.areas(candidate).overlap_px2, 500);
}

TEST(Seamless, DistancesAreThoseToTheNearestImage) {
  Scene scene;
  Collage& collage = scene.collage;
  const Placement placed = test::piece(3, 30, {10, 90});
  EXPECT_NEAR(collage.distance_px(placed, {220, 90}), collage.distance_px(placed, {-20, 90}), 1e-4);
  EXPECT_LT(collage.distance_px(placed, {220, 90}), 30);
}

TEST(Seamless, WithoutEdgesTheFirstPieceFollowsFromTheSeed) {
  CollageSettings s = settings();
  s.stop.pieces = 1;
  s.pieces.min_rotation_rad = s.pieces.max_rotation_rad = 1;
  std::set<ShapeId> shapes;
  for (s.seed = 1; s.seed <= 6; ++s.seed) {
    const std::vector<Placement> first = run(both_ways(), s).placements;
    ASSERT_EQ(first.size(), 1u);
    EXPECT_EQ(run(both_ways(), s).placements, first);
    EXPECT_NEAR(first[0].canvas_from_shape.rotation_rad(), 1, 1e-5);
    shapes.insert(first[0].shape);
  }
  EXPECT_GT(shapes.size(), 2u);
}

TEST(Seamless, WhereNoPieceFitsTheCollageIsEmpty) {
  CollageSettings s = settings();
  s.pieces.min_scale_px = 80;
  const CollageResult result = run(make_seamless_canvas(40, 30, true, true), s);
  EXPECT_TRUE(result.placements.empty());
  EXPECT_EQ(result.statistics.stopped_by, StopReason::full);
}

TEST(Seamless, DoesNotDependOnHowTheLibraryIsDivided) {
  const auto whole = run(both_ways(), settings()).placements;
  ASSERT_GT(whole.size(), 5u);
  EXPECT_EQ(run(both_ways(), settings(), {5}).placements, whole);
  EXPECT_EQ(run(both_ways(), settings(), {1, 2, 9}).placements, whole);
}

/// Filling and improving, interrupted after every step.
TEST(Seamless, GoesOnFromItsCheckpoints) {
  const Canvas canvas = make_seamless_canvas(160, 120, true, true);
  const CollageSettings s = stopped_collage::improved();
  SilentObserver silent;
  const CollageResult whole = stopped_collage::run(s, {}, silent, {}, canvas);
  EXPECT_EQ(whole.statistics.trials, 12u);
  stopped_collage::KeepLatest keeper;
  CheckpointState state;
  const CheckpointState* from = nullptr;
  CollageResult result;
  int interruptions = 0;
  do {
    stopped_collage::StopAfter stop(1);
    result = stopped_collage::run(s, {interruptions % 2 ? 3u : 7u}, stop, {from, &keeper}, canvas);
    state = keeper.latest;
    from = &state;
  } while (result.unfinished && ++interruptions < 200);
  EXPECT_GT(interruptions, 12);
  EXPECT_EQ(result.placements, whole.placements);
  EXPECT_EQ(result.statistics.target_samples, whole.statistics.target_samples);
  EXPECT_EQ(result.statistics.trials_kept, whole.statistics.trials_kept);
}

}  // namespace test_seamless
}  // namespace tessera::master
