// Wishes in whole collages: places of shapes, given pieces, and each shape once; each also with interruptions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/base/stop.h"
#include "core/collage/placed_outlines.h"
#include "core/geometry/polygon_index.h"
#include "core/matching/sized_settings.h"
#include "core/shape/mirrored_shape.h"
#include "interrupted_collage.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_wishes {

using namespace whole_collage;

/// The library's shapes, followed by the mirror images of all of them.
const std::vector<Shape>& mirrored_library() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> all = library();
    for (const Shape& shape : library()) all.push_back(mirror_image(shape, PadParameters{}.levels));
    return all;
  }();
  return shapes;
}

class MirroredShapes : public test::VectorShapes {
 public:
  MirroredShapes() : VectorShapes(mirrored_library()) {}
  ShapeId silhouette(ShapeId id) const override { return drawing(id); }
  ShapeId drawing(ShapeId id) const override { return ShapeId(index_of(id) % std::uint32_t(library().size())); }
};

CollageResult run_mirrored(const Canvas& canvas, const CollageSettings& s, std::vector<std::uint32_t> cuts = {}) {
  const MatchingContext context = make_matching_context(s, std::uint32_t(mirrored_library().size()));
  CompositeMatcher matcher = test::divided_matcher(mirrored_library(), context, std::move(cuts));
  MirroredShapes shapes;
  SilentObserver silent;
  return make_collage(canvas, s, matcher, shapes, silent);
}

/// The distance between the outlines of two pieces, or of a piece and an image of the other.
float distance_px(const Placement& a, const Placement& b, const Period& period = {}) {
  const PolygonIndex outline(placed_outline(library()[index_of(a.shape)].outline, a.canvas_from_shape));
  float nearest_px = 1e6f;
  for (const Vec2 image : period.offsets()) {
    const Outline other = placed_outline(library()[index_of(b.shape)].outline, moved(b.canvas_from_shape, image));
    for (const Vec2 p : other.curves.front()) nearest_px = std::min(nearest_px, outline.approach(p, 1e6f).distance);
  }
  return nearest_px;
}

/// The least distance over all pairs for which count(a, b) is true.
template <class Count>
float least_distance_px(const std::vector<Placement>& placements, Count count, const Period& period = {}) {
  float least_px = 1e6f;
  for (std::size_t i = 0; i < placements.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!count(placements[i], placements[j])) continue;
      least_px = std::min(least_px, distance_px(placements[i], placements[j], period));
    }
  }
  return least_px;
}

bool same_shape(const Placement& a, const Placement& b) { return a.shape == b.shape; }

std::map<std::uint32_t, int> uses(const std::vector<Placement>& placements) {
  std::map<std::uint32_t, int> count;
  for (const Placement& p : placements) ++count[index_of(p.shape)];
  return count;
}

/// Two regions side by side on a page of 240 x 140 px. The left one has the given width.
Canvas two_regions(int left_px = 120) {
  Canvas canvas = make_rectangle_canvas(240, 140);
  for (const bool right : {false, true}) {
    Grid<float> coverage(480, 280, 0.f);
    for (int y = 0; y < 280; ++y) {
      for (int x = 0; x < 480; ++x) coverage(x, y) = float((x >= 2 * left_px) == right);
    }
    const Canvas part = make_mask_canvas(coverage);
    canvas.regions.push_back({part.distance, part.area_px2});
  }
  return canvas;
}

/// Each region begins with a relaxation of its pieces, while the pieces of earlier regions stay.
TEST(Wishes, PiecesOfEachRegionMoveTogether) {
  const Canvas canvas = two_regions();
  CollageSettings s = settings();
  s.wishes.regions.resize(2);
  const CollageResult filled = run(canvas, s);
  s.improve.trials = 2;
  const CollageResult relaxed = run(canvas, s);
  EXPECT_EQ(relaxed.statistics.trials, 2u);
  EXPECT_EQ(relaxed.statistics.trials_kept, 2u);
  EXPECT_GT(quality(canvas, relaxed).coverage, quality(canvas, filled).coverage + 0.002);
  EXPECT_LT(quality(canvas, relaxed).overlap, 0.01);
}

std::vector<GivenPiece> as_free(const std::vector<Placement>& placements, std::size_t locked) {
  std::vector<GivenPiece> pieces;
  for (const Placement& p : placements) pieces.push_back({p.shape, p.canvas_from_shape, pieces.size() < locked});
  return pieces;
}

/// The number of moved pieces in the left region and in the right one.
std::array<int, 2> moved_by_region(const std::vector<GivenPiece>& given, const std::vector<Placement>& placements) {
  std::array<int, 2> moved{};
  for (const GivenPiece& piece : given) {
    const bool stands = std::any_of(placements.begin(), placements.end(),
                                    [&](const Placement& p) { return p.canvas_from_shape == piece.canvas_from_shape; });
    moved[piece.canvas_from_shape.tx > 120] += !stands;
  }
  return moved;
}

/// Each free piece moves while its own region is improved; locked pieces never move.
TEST(Wishes, FreePiecesMoveInTheirOwnRegion) {
  const Canvas canvas = two_regions();
  CollageSettings s = settings();
  s.wishes.regions.resize(2);
  const CollageResult filled = run(canvas, s);
  constexpr std::size_t kLocked = 2;
  s.wishes.given = as_free(filled.placements, kLocked);
  std::swap(s.wishes.given[kLocked], s.wishes.given.back());  // pieces may come in any order of the regions
  s.improve.trials = 2;
  const CollageResult relaxed = run(canvas, s);
  EXPECT_EQ(relaxed.statistics.trials_kept, 2u);
  EXPECT_GT(quality(canvas, relaxed).coverage, quality(canvas, filled).coverage + 0.002);
  EXPECT_LT(quality(canvas, relaxed).overlap, 0.01);
  EXPECT_LT(quality(canvas, relaxed).outside, 0.01);
  const std::array<int, 2> moved = moved_by_region(s.wishes.given, relaxed.placements);
  EXPECT_GT(moved[0], 1);
  EXPECT_GT(moved[1], 1);
  for (std::size_t i = 0; i < kLocked; ++i) {
    EXPECT_EQ(relaxed.placements[i].canvas_from_shape, filled.placements[i].canvas_from_shape);
  }
}

TEST(Wishes, FreePiecesOfRegionsAreTheSameAfterInterruptions) {
  const Canvas canvas = two_regions();
  CollageSettings s = settings();
  s.wishes.regions.resize(2);
  std::vector<Placement> some = run(canvas, s).placements;
  for (std::size_t i = some.size(); i > 0; --i) {
    if (i % 2 == 0) some.erase(some.begin() + std::ptrdiff_t(i - 1));
  }
  s.wishes.given = as_free(some, 1);
  s.wishes.given.push_back({ShapeId{4}, {7, 0, 230, 10}, false});  // smaller than the job's pieces
  s.improve.trials = 6;
  expect_repeatable(canvas, s, run(canvas, s));
}

TEST(Wishes, SizesAndAnglesAreThoseThatWereWishedFor) {
  CollageSettings s = settings();
  s.pieces.several.scale_px = {{20, 24}, {60, 90}};
  s.pieces.several.rotation_rad = {{0, 0}, {1.5707964f, 1.5707964f}};
  const Canvas canvas = make_rectangle_canvas(240, 180);
  const CollageResult result = run(canvas, s);
  ASSERT_GT(result.placements.size(), 8u);
  std::set<bool> turned;
  for (const Placement& p : result.placements) {
    const float scale = p.canvas_from_shape.scale();
    EXPECT_TRUE((scale > 19.99f && scale < 24.01f) || (scale > 59.99f && scale < 90.01f)) << scale;
    const float angle = p.canvas_from_shape.rotation_rad();
    EXPECT_TRUE(std::abs(angle) < 1e-4f || std::abs(angle - 1.5707964f) < 1e-4f) << angle;
    turned.insert(angle > 1);
  }
  EXPECT_EQ(turned.size(), 2u);
  expect_repeatable(canvas, s, result);
}

TEST(Wishes, OneSizeFillsToo) {
  CollageSettings s = settings();
  s.pieces.min_scale_px = s.pieces.max_scale_px = 40;
  const Canvas canvas = make_rectangle_canvas(240, 180);
  const CollageResult result = run(canvas, s);
  EXPECT_GT(quality(canvas, result).coverage, 0.6);
  for (const Placement& p : result.placements) EXPECT_NEAR(p.canvas_from_shape.scale(), 40, 0.001f);
}

TEST(Wishes, WeightsChangeHowOftenAShapeStands) {
  CollageSettings s = settings();
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const int plain = uses(run(canvas, s).placements)[3];
  s.wishes.classes.resize(2);
  s.wishes.classes[1].weight = 3;
  s.wishes.class_of_shape.assign(library().size(), 0);
  s.wishes.class_of_shape[3] = 1;
  EXPECT_GT(uses(run(canvas, s).placements)[3], plain);
  s.wishes.classes[1].weight = 0;
  EXPECT_EQ(uses(run(canvas, s).placements)[3], 0);
}

TEST(Wishes, GivenPiecesStandAndTheOthersKeepClear) {
  CollageSettings s = improved(6);
  const Similarity hero{0, 110, 130, 80};
  s.wishes.given = {{ShapeId{2}, hero}};
  const Canvas canvas = make_rectangle_canvas(260, 180);
  const CollageResult result = run(canvas, s);
  ASSERT_GT(result.placements.size(), 5u);
  EXPECT_EQ(result.placements[0].shape, ShapeId{2});
  EXPECT_EQ(result.placements[0].canvas_from_shape, hero);
  const Quality q = quality(canvas, result);
  EXPECT_GT(q.coverage, 0.75);
  EXPECT_LT(q.overlap, 0.006);
  expect_repeatable(canvas, s, result);
}

TEST(Wishes, RegionsHaveTheirOwnShapesAndSizes) {
  CollageSettings s = improved(4);
  s.wishes.regions.resize(2);
  s.wishes.regions[1].poses.scale_px = {{20, 30}};
  s.wishes.classes.resize(2);
  s.wishes.classes[0].in_region = {1, 1};
  s.wishes.classes[1].in_region = {0, 1};
  s.wishes.class_of_shape.assign(library().size(), 0);
  for (std::size_t i = 0; i < library().size(); i += 2) s.wishes.class_of_shape[i] = 1;
  const Canvas canvas = two_regions();
  const CollageResult result = run(canvas, s);
  int left = 0;
  int right = 0;
  for (const Placement& p : result.placements) {
    if (p.canvas_from_shape.tx < 120) {
      ++left;
      EXPECT_EQ(index_of(p.shape) % 2, 1u);
    } else {
      ++right;
      EXPECT_LE(p.canvas_from_shape.scale(), 30.01f);
    }
    float leftmost = 1e9f;
    float rightmost = -1e9f;
    for (const Vec2& point : library()[index_of(p.shape)].outline.curves.front()) {
      const float x = p.canvas_from_shape.apply(point).x;
      leftmost = std::min(leftmost, x);
      rightmost = std::max(rightmost, x);
    }
    EXPECT_TRUE(rightmost < 122 || leftmost > 118) << "within its region";
  }
  EXPECT_GT(left, 2);
  EXPECT_GT(right, 10);
  EXPECT_LT(quality(canvas, result).overlap, 0.006);
  expect_repeatable(canvas, s, result);
}

/// Notes the number of trials at which a piece was placed without a trial: then the next region began.
class NextRegion : public SilentObserver {
 public:
  void progressed(const Progress& now) override {
    if (now.trials > 0 && now.trials == trials_ && now.pieces > pieces_) began_after.insert(now.trials);
    trials_ = now.trials;
    pieces_ = now.pieces;
  }
  std::set<std::uint64_t> began_after;

 private:
  std::uint64_t trials_ = 0;
  std::size_t pieces_ = 0;
};

TEST(Wishes, TrialsAreDividedAmongRegionsByArea) {
  CollageSettings s = improved(8);
  s.wishes.regions.resize(2);
  NextRegion observer;
  const CollageResult result = stopped_collage::run(s, {}, observer, {}, two_regions(180), library());
  EXPECT_EQ(result.statistics.trials, 8u);
  EXPECT_EQ(observer.began_after, std::set<std::uint64_t>{6});
}

TEST(Wishes, WhatACollageLimitsDoesNotReachTheNextOne) {
  const CollageSettings s = settings();
  const Canvas canvas = make_rectangle_canvas(160, 120);
  const MatchingContext context = make_matching_context(s, std::uint32_t(library().size()));
  CompositeMatcher matcher = test::divided_matcher(library(), context, {});
  test::VectorShapes shapes(library());
  SilentObserver observer;
  CollageSettings once = s;
  once.pieces.uses = 1;
  make_collage(canvas, once, matcher, shapes, observer);
  EXPECT_EQ(make_collage(canvas, s, matcher, shapes, observer).placements, run(canvas, s).placements);
}

TEST(Wishes, WithLeastUsesNoShapeComesAgainBeforeAllAreThere) {
  CollageSettings s = settings();
  s.pieces.least_uses = 1;
  s.pieces.max_scale_px = 40;
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const CollageResult result = run(canvas, s);
  ASSERT_GT(result.placements.size(), library().size());
  std::set<std::uint32_t> first;
  for (std::size_t i = 0; i < library().size(); ++i) first.insert(index_of(result.placements[i].shape));
  EXPECT_EQ(first.size(), library().size());
}

TEST(Wishes, FitAllFindsSizesAtWhichEveryShapeHasItsPlace) {
  CollageSettings s = improved(4);
  s.pieces.fit_all = true;
  s.pieces.uses = 1;
  const Canvas canvas = make_rectangle_canvas(500, 300);
  const double factor = first_size_factor(s, std::uint32_t(library().size()), canvas.area_px2);
  const CollageSettings sized = with_sizes_times(factor, s);
  const CollageResult result = run(canvas, sized);
  EXPECT_EQ(uses(result.placements).size(), library().size());
  EXPECT_EQ(result.placements.size(), library().size());
  EXPECT_EQ(result.statistics.stopped_by, StopReason::used_up);
  EXPECT_GT(quality(canvas, result).coverage, 0.65);
  expect_repeatable(canvas, sized, result);
}

TEST(Wishes, FitAllKeepsTheSizesOfShapesInProportion) {
  CollageSettings s = settings();
  s.pieces.fit_all = true;
  s.pieces.uses = 1;
  s.wishes.classes.resize(2);
  s.wishes.classes[0].poses.scale_px = {{100, 100}};
  s.wishes.classes[1].poses.scale_px = {{50, 50}};
  s.wishes.class_of_shape.assign(library().size(), 1);
  s.wishes.class_of_shape[0] = s.wishes.class_of_shape[5] = 0;
  const Canvas canvas = make_rectangle_canvas(500, 300);
  const double factor = first_size_factor(s, std::uint32_t(library().size()), canvas.area_px2);
  const CollageResult result = run(canvas, with_sizes_times(factor, s));
  ASSERT_EQ(result.placements.size(), library().size());
  std::map<bool, std::set<int>> sizes;
  for (const Placement& p : result.placements) {
    const bool large = index_of(p.shape) == 0 || index_of(p.shape) == 5;
    sizes[large].insert(int(std::lround(1000 * p.canvas_from_shape.scale())));
  }
  EXPECT_EQ(sizes[false].size(), 1u);
  EXPECT_EQ(sizes[true].size(), 1u);
  EXPECT_NEAR(*sizes[true].begin(), 2 * *sizes[false].begin(), 3);
}

TEST(Wishes, MirrorImagesStandBesideTheirShapesAndCountAsThem) {
  CollageSettings s = settings();
  s.pieces.uses = 2;
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const CollageResult result = run_mirrored(canvas, s);
  std::map<std::uint32_t, int> of_drawing;
  int mirrored = 0;
  for (const Placement& p : result.placements) {
    ++of_drawing[index_of(p.shape) % std::uint32_t(library().size())];
    mirrored += index_of(p.shape) >= library().size();
  }
  for (const auto& [drawing, count] : of_drawing) EXPECT_LE(count, 2) << drawing;
  EXPECT_GT(mirrored, 3);
  EXPECT_LT(mirrored, int(result.placements.size()) - 3);
  EXPECT_EQ(run_mirrored(canvas, s, {3, 14, 20}).placements, result.placements);
}

TEST(Wishes, FitAllGivesAMirrorImageThePlaceOfItsShape) {
  CollageSettings s = settings();
  s.pieces.fit_all = true;
  s.pieces.uses = 1;
  const Canvas canvas = make_rectangle_canvas(500, 300);
  std::vector<std::uint32_t> drawings;
  for (std::uint32_t i = 0; i < mirrored_library().size(); ++i) drawings.push_back(i % std::uint32_t(library().size()));
  const auto shapes = std::uint32_t(mirrored_library().size());
  const double factor = first_size_factor(s, shapes, canvas.area_px2, drawings);
  EXPECT_EQ(factor, first_size_factor(s, std::uint32_t(library().size()), canvas.area_px2));
  const CollageResult result = run_mirrored(canvas, with_sizes_times(factor, s));
  EXPECT_EQ(result.placements.size(), library().size());
  EXPECT_GT(quality_of(canvas, result.placements, mirrored_library()).coverage, 0.65);
}

TEST(Wishes, PiecesOfAShapeKeepApart) {
  CollageSettings s = improved(4);
  s.pieces.max_scale_px = 40;
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const CollageResult free = run(canvas, s);
  s.pieces.apart_px = 60;
  const CollageResult result = run(canvas, s);
  EXPECT_LT(least_distance_px(free.placements, same_shape), 30) << "there is something to keep";
  EXPECT_GE(least_distance_px(result.placements, same_shape), 60);
  EXPECT_LT(least_distance_px(result.placements, same_shape), 66) << "no more than was wished for";
  EXPECT_GT(uses(result.placements).size(), 8u);
  EXPECT_GT(quality(canvas, result).coverage, 0.5);
  expect_repeatable(canvas, s, result);
}

/// Shapes 3, 4 and 5 form a class, called company here, whose pieces keep this distance.
CollageSettings with_company(const ApartWish& apart) {
  CollageSettings s = settings();
  s.pieces.max_scale_px = 40;
  s.wishes.classes.resize(2);
  s.wishes.classes[1].apart = apart;
  s.wishes.class_of_shape.assign(library().size(), 0);
  s.wishes.class_of_shape[3] = s.wishes.class_of_shape[4] = s.wishes.class_of_shape[5] = 1;
  return s;
}

/// The job's distance does not apply to shape 6.
TEST(Wishes, ShapesThatAreNamedTogetherKeepApart) {
  CollageSettings s = with_company({7, 80});
  s.pieces.apart_px = 20;
  s.objective.balance = 0;  // with large pieces, those of one shape come near to each other
  s.wishes.classes.emplace_back().apart = {8, 0};
  s.wishes.class_of_shape[6] = 2;
  const Canvas canvas = make_rectangle_canvas(300, 220);
  const CollageResult result = run(canvas, s);
  const auto in_company = [](const Placement& p) { return index_of(p.shape) >= 3 && index_of(p.shape) <= 5; };
  const auto both = [&](const Placement& a, const Placement& b) { return in_company(a) && in_company(b); };
  const auto one = [&](const Placement& a, const Placement& b) { return in_company(a) != in_company(b); };
  const auto others = [&](const Placement& a, const Placement& b) {
    return same_shape(a, b) && !in_company(a) && index_of(a.shape) != 6;
  };
  const float least_px = least_distance_px(result.placements, both);
  EXPECT_GE(least_px, 80);
  EXPECT_LT(least_px, 1e6f) << "more than one of them stands";
  EXPECT_LT(least_distance_px(result.placements, one), 3) << "with all others they are close";
  EXPECT_GE(least_distance_px(result.placements, others), 20);
  EXPECT_LT(least_distance_px(result.placements, others), 30);
  EXPECT_LT(least_distance_px(result.placements,
                              [](const Placement& a, const Placement& b) {
                                return index_of(a.shape) == 6 && index_of(b.shape) == 6;
                              }),
            20);
}

/// There is room for only one piece of the company, though each of its shapes is wished for. The other shapes need not wait.
TEST(Wishes, NobodyWaitsForAShapeThatIsShutOut) {
  CollageSettings s = with_company({0, 1000});
  s.pieces.least_uses = 1;
  const CollageResult result = run(make_rectangle_canvas(300, 220), s);
  EXPECT_GT(result.placements.size(), 2 * library().size());
  std::map<std::uint32_t, int> count = uses(result.placements);
  EXPECT_EQ(count[3] + count[4] + count[5], 1);
  EXPECT_EQ(count.size(), library().size()) << "all others stand; counting made entries of the three";
}

/// The case costs as little as if each shape could be used once: no rounds or matching are spent on shapes that already stand.
TEST(Wishes, ShapesThatAreShutOutEverywhereCostNothing) {
  CollageSettings s = settings();
  s.pieces.max_scale_px = 40;
  const Canvas canvas = make_rectangle_canvas(300, 220);
  CollageSettings once = s;
  once.pieces.uses = 1;
  s.pieces.apart_px = 1000;
  const CollageResult apart = run(canvas, s);
  const CollageResult used_once = run(canvas, once);
  EXPECT_EQ(apart.placements.size(), library().size());
  EXPECT_EQ(uses(apart.placements).size(), library().size());
  EXPECT_EQ(apart.statistics.stopped_by, StopReason::full);
  EXPECT_EQ(used_once.statistics.stopped_by, StopReason::used_up);
  EXPECT_LT(apart.statistics.target_samples, 1.2 * double(used_once.statistics.target_samples));
  expect_repeatable(canvas, s, apart);
}

TEST(Wishes, AcrossASeamPiecesKeepApartToo) {
  CollageSettings s = settings();
  s.pieces.max_scale_px = 40;
  s.pieces.apart_px = 60;
  const Canvas canvas = make_seamless_canvas(260, 200, true, true);
  const CollageResult result = run(canvas, s);
  ASSERT_GT(result.placements.size(), 12u);
  EXPECT_GE(least_distance_px(result.placements, same_shape, canvas.period), 60);
}

TEST(Wishes, ALibraryThatIsUsedUpIsSaidAsSuch) {
  CollageSettings s = settings();
  s.pieces.uses = 1;
  s.pieces.max_scale_px = 30;
  EXPECT_EQ(run(make_rectangle_canvas(300, 220), s).statistics.stopped_by, StopReason::used_up);
}

}  // namespace test_wishes
}  // namespace tessera::master
