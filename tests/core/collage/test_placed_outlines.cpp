// The rule that decides which pieces may stand beside placed pieces, against brute force over all segments and all vertices.
#include "core/collage/placed_outlines.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <ctime>

#include "core/field/keep_out.h"
#include "core/settings/tuning.h"
#include "support/polygon_distance.h"
#include "support/synthetic_shapes.h"

namespace tessera {
namespace test_placed_outlines {

constexpr float kPadding_px = 6;
constexpr double kNeeded_px = kPadding_px + 0.002;  // for the three decimals of pieces.geojson
constexpr double kRounding_px = 2e-3;
constexpr double kByFields_px = 0.1;  // the tested vertices are chosen by fields

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = [] {
    std::vector<Shape> made{test::make_test_shape("star", test::star_outline(5)),
                            test::make_test_shape("bean", test::bean_outline()),
                            test::make_test_shape("ring", test::ring_outline(0.6f))};
    for (std::uint32_t seed = 1; seed < 4; ++seed)
      made.push_back(test::make_test_shape("blob", test::blob_outline(seed)));
    made.push_back(test::make_test_shape("spikes", test::star_outline(7, 0.25f)));
    for (Shape& shape : made) {  // brute force takes long
      for (std::vector<Vec2>& curve : shape.outline.curves) curve = test::resampled(curve, 80);
    }
    return made;
  }();
  return all;
}

/// A shape with four vertices and long sides.
Shape square() {
  Shape shape = test::make_test_shape("square", test::rectangle_outline(1, 1));
  shape.outline.curves = {{{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}}};
  return shape;
}

constexpr double kWritten_px = 0.002;  // the error of positions with three decimals
const float kOverlap_px = PieceSettings().overlap_px;

PieceSettings padded_by(float padding_px) {
  PieceSettings pieces;
  pieces.padding_px = padding_px;
  return pieces;
}

PieceSettings overlapping_by(float overlap_px) {
  PieceSettings pieces;
  pieces.overlap_px = overlap_px;
  return pieces;
}

/// Pieces on a canvas whose edge is far away.
struct Scene {
  explicit Scene(const PieceSettings& pieces, float canvas_px = 400)
      : free(make_rectangle_canvas(int(canvas_px), int(canvas_px)), pieces),
        outlines(free, pieces) {}
  explicit Scene(float padding_px, float canvas_px = 400) : Scene(padded_by(padding_px), canvas_px) {}

  void add(std::uint32_t shape, const Similarity& pose) {
    outlines.add({ShapeId{shape}, pose, 1, 1}, shapes()[shape].outline, INFINITY);
    free.stamp(shapes()[shape], pose);
    placed.push_back(placed_outline(shapes()[shape].outline, pose));
  }

  FreeField free;
  PlacedOutlines outlines;
  std::vector<Outline> placed;
};

Similarity pose(float scale_px, float angle_rad, Vec2 centre) {
  return {scale_px * std::cos(angle_rad), scale_px * std::sin(angle_rad), centre.x, centre.y};
}

std::uint32_t any_shape() { return *rc::gen::inRange<std::uint32_t>(0, std::uint32_t(shapes().size())); }

float any_number(int low, int high) { return 0.01f * float(*rc::gen::inRange(100 * low, 100 * high)); }

Similarity any_pose(float centre_px, int apart_px) {
  const float scale = any_number(10, 40);
  const float angle = any_number(0, 6);
  const float x = centre_px + any_number(-apart_px, apart_px);
  return pose(scale, angle, {x, centre_px + any_number(-apart_px, apart_px)});
}

/// Moves the piece from the left towards the outline until it is about `distance_px` away, or that deep in it.
Similarity pose_beside(const Outline& other, std::uint32_t shape, float distance_px) {
  Similarity at = any_pose(200, 10);
  at.tx = 130;
  for (float gap = INFINITY; gap > std::max(distance_px, 0.f) + 0.1f;) {
    gap = float(test::polygon_distance(placed_outline(shapes()[shape].outline, at), other));
    at.tx += 0.9f * std::max(gap - std::max(distance_px, 0.f), 0.f);
  }
  at.tx -= std::min(distance_px, 0.f);
  return at;
}

Outline moved(Outline outline, Vec2 way) {
  for (std::vector<Vec2>& curve : outline.curves) {
    for (Vec2& p : curve) p = p + way;
  }
  return outline;
}

TEST(PlacedOutlines, WithPaddingEachNeighbourThatIsTooNearIsAConflict) {
  EXPECT_TRUE(rc::check([] {
    Scene scene(kPadding_px);
    for (int k = 0; k < 3; ++k) scene.add(any_shape(), any_pose(200, 60));
    const std::uint32_t shape = any_shape();
    const Similarity where = any_pose(200, 60);
    const Outline piece = placed_outline(shapes()[shape].outline, where);
    std::size_t too_near = 0;
    for (const Outline& other : scene.placed) {
      const double distance = test::polygon_distance(piece, other);
      RC_PRE(std::abs(distance - kNeeded_px) > kRounding_px);
      too_near += distance < kNeeded_px;
    }
    RC_TAG(too_near);
    RC_ASSERT(scene.outlines.conflicts(shapes()[shape], where).size() == too_near);
  }));
}

/// Images of pieces count, too: the scene repeats every 200 px.
TEST(PlacedOutlines, NeighboursAcrossASeamAreConflicts) {
  const Canvas canvas = make_seamless_canvas(200, 200, true, true);
  EXPECT_TRUE(rc::check([&] {
    const FreeField free(canvas, padded_by(kPadding_px));
    PlacedOutlines outlines(free, padded_by(kPadding_px));
    const auto shape = any_shape();
    const Similarity there = canvas.period.wrapped(any_pose(200, 30));
    outlines.add({ShapeId{shape}, there, 1, 1}, shapes()[shape].outline, INFINITY);
    const auto other = any_shape();
    const Similarity where = canvas.period.wrapped(any_pose(200, 30));
    const Outline piece = placed_outline(shapes()[other].outline, where);
    std::size_t too_near = 0;
    for (const Vec2 offset : canvas.period.offsets()) {
      const double distance =
          test::polygon_distance(piece, placed_outline(shapes()[shape].outline, tessera::moved(there, offset)));
      RC_PRE(std::abs(distance - kNeeded_px) > kRounding_px);
      too_near += distance < kNeeded_px;
    }
    RC_TAG(too_near);
    RC_ASSERT(outlines.conflicts(shapes()[other], where).size() == too_near);
  }));
}

TEST(PlacedOutlines, APieceThatReachesItsOwnImageHasNoWayOut) {
  const FreeField free(make_seamless_canvas(80, 300, true, false), padded_by(4));
  const PlacedOutlines outlines(free, padded_by(4));
  EXPECT_TRUE(outlines.conflicts(square(), pose(75, 0, {40, 150})).empty());
  EXPECT_EQ(outlines.conflicts(square(), pose(77, 0, {40, 150})), std::vector<Vec2>{Vec2{}});
  EXPECT_TRUE(outlines.conflicts(square(), pose(290, 0, {40, 150})).size() > 0);
}

TEST(PlacedOutlines, TheWayOutLeadsAwayByWhatIsMissing) {
  EXPECT_TRUE(rc::check([] {
    Scene scene(kPadding_px);
    scene.add(any_shape(), any_pose(200, 5));
    const std::uint32_t shape = any_shape();
    const Similarity where = pose_beside(scene.placed[0], shape, any_number(1, 6));
    const Outline piece = placed_outline(shapes()[shape].outline, where);
    const double distance = test::polygon_distance(piece, scene.placed[0]);
    RC_PRE(distance > 0.1 && distance < kNeeded_px - 0.1);
    const std::vector<Vec2> ways = scene.outlines.conflicts(shapes()[shape], where);
    RC_ASSERT(ways.size() == 1u);
    RC_ASSERT(std::abs(double(norm(ways[0])) - (kNeeded_px - distance)) < 1e-2);
    RC_ASSERT(test::polygon_distance(moved(piece, ways[0] * 0.01f), scene.placed[0]) > distance);
  }));
}

TEST(PlacedOutlines, AShapeThatLiesInAnotherIsAConflictHoweverFarTheBoundariesAre) {
  Scene scene(2);
  scene.add(1, pose(100, 0, {200, 200}));
  EXPECT_EQ(scene.outlines.conflicts(shapes()[3], pose(10, 0, {200, 200})).size(), 1u);
  Scene within(2);
  within.add(3, pose(10, 0, {200, 200}));
  EXPECT_EQ(within.outlines.conflicts(shapes()[1], pose(100, 0, {200, 200})).size(), 1u);
  Scene in_the_hole(2);
  in_the_hole.add(2, pose(100, 0, {200, 200}));
  EXPECT_TRUE(in_the_hole.outlines.conflicts(shapes()[3], pose(10, 0, {200, 200})).empty());
}

/// The depth of a point in the outline; 0 outside.
double depth(Vec2 p, const Outline& outline) {
  return test::lies_in(outline, p) ? test::boundary_distance({{{p}}}, outline) : 0;
}

struct Deepest {
  double depth_px = 0;
  Vec2 vertex;
};

Deepest deepest_vertex(const Outline& inner, const Outline& outer) {
  Deepest deepest;
  for (const std::vector<Vec2>& curve : inner.curves) {
    for (const Vec2 p : curve) {
      const double at = depth(p, outer);
      if (at > deepest.depth_px) deepest = {at, p};
    }
  }
  return deepest;
}

/// A piece beside another or in it, and the depths of each one's vertices in the other.
struct Meeting {
  /// The pieces are `least_px` to `most_px` apart; negative numbers mean overlap.
  Meeting(const PieceSettings& pieces, int least_px, int most_px) : scene(pieces) {
    scene.add(any_shape(), any_pose(200, 5));
    shape = any_shape();
    where = pose_beside(other(), shape, any_number(least_px, most_px));
    piece = placed_outline(shapes()[shape].outline, where);
    of_piece = deepest_vertex(piece, other());
    of_other = deepest_vertex(other(), piece);
  }

  const Outline& other() const { return scene.placed[0]; }
  std::vector<Vec2> ways() const { return scene.outlines.conflicts(shapes()[shape], where); }

  Scene scene;
  std::uint32_t shape = 0;
  Similarity where;
  Outline piece;
  Deepest of_piece, of_other;
};

/// If no depth is allowed, neither a corner nor a side may reach into the other piece.
TEST(PlacedOutlines, WithoutOverlapOutlinesThatMeetAreAConflict) {
  EXPECT_TRUE(rc::check([] {
    const Meeting meeting(overlapping_by(0), -1, 1);
    const double distance = test::polygon_distance(meeting.piece, meeting.other());
    RC_PRE(std::abs(distance - kWritten_px) > 1e-4);
    RC_TAG(distance < kWritten_px);
    RC_ASSERT(meeting.ways().empty() == (distance > kWritten_px));
  }));
}

TEST(PlacedOutlines, WithoutPaddingEachVertexThatLiesTooDeepIsAConflict) {
  EXPECT_TRUE(rc::check([] {
    const float allowed_px = *rc::gen::element(0.4f, kOverlap_px, 2.5f);
    const Meeting meeting(overlapping_by(allowed_px), -5, 1);
    const Deepest& of_piece = meeting.of_piece;
    const Deepest& of_other = meeting.of_other;
    for (const Deepest& d : {of_piece, of_other}) RC_PRE(std::abs(d.depth_px - allowed_px) > kByFields_px);
    const bool piece_too_deep = of_piece.depth_px > allowed_px;
    const bool other_too_deep = of_other.depth_px > allowed_px;
    RC_TAG(int(piece_too_deep) + 2 * int(other_too_deep));
    const std::vector<Vec2> ways = meeting.ways();
    RC_ASSERT(ways.size() == std::size_t(piece_too_deep) + std::size_t(other_too_deep));
    const auto is_way_out = [allowed_px](Vec2 way, const Deepest& d, const Outline& outer) {
      if (d.depth_px >= kMaxPushDepth_px) return true;  // there is no short way out
      return std::abs(double(norm(way)) - (d.depth_px - allowed_px)) < kRounding_px &&
             std::abs(depth(d.vertex + way, outer) - allowed_px) < kRounding_px;
    };
    if (piece_too_deep) RC_ASSERT(is_way_out(ways.front(), of_piece, meeting.other()));
    if (other_too_deep) RC_ASSERT(is_way_out(ways.back() * -1.f, of_other, meeting.piece));
  }));
}

/// Positions are written with three decimals.
TEST(PlacedOutlines, PaddingIsKeptBetweenRoundedPositionsToo) {
  Scene scene(kPadding_px);
  scene.outlines.add({ShapeId{0}, pose(40, 0, {200, 200}), 1, 1}, square().outline, INFINITY);
  const auto conflicts = [&](float distance_px) {
    return scene.outlines.conflicts(square(), pose(40, 0, {240 + distance_px, 210}));
  };
  EXPECT_EQ(conflicts(kPadding_px + 0.001f).size(), 1u);
  EXPECT_TRUE(conflicts(kPadding_px + 0.003f).empty());
}

TEST(PlacedOutlines, TheWayOutOfALargeOverlapLeadsAwayFromTheNeighbour) {
  for (const float padding_px : {0.f, kPadding_px}) {
    Scene scene(padding_px);
    scene.add(1, pose(60, 0, {200, 200}));
    const std::vector<Vec2> ways = scene.outlines.conflicts(shapes()[1], pose(30, 0, {210, 200}));
    ASSERT_FALSE(ways.empty());
    for (const Vec2 way : ways) EXPECT_GT(way.x, 5 * std::abs(way.y)) << padding_px;
  }
}

/// The way out is as long as the depth of the deepest vertex plus the distance needed. A shorter way would need several steps.
TEST(PlacedOutlines, TheWayOutOfACrossingLeadsTheDeepestVertexOut) {
  EXPECT_TRUE(rc::check([] {
    const float padding_px = *rc::gen::element(0.f, kPadding_px);
    PieceSettings pieces = padded_by(padding_px);
    pieces.overlap_px = 0;
    const Meeting meeting(pieces, -3, 0);
    const double own_px = meeting.of_piece.depth_px;
    const double others_px = meeting.of_other.depth_px;
    const bool by_own = own_px > others_px;
    const Deepest& deepest = by_own ? meeting.of_piece : meeting.of_other;
    RC_PRE(deepest.depth_px > 0.1 && std::abs(own_px - others_px) > kRounding_px);
    RC_PRE(deepest.depth_px < kMaxPushDepth_px);
    const std::vector<Vec2> ways = meeting.ways();
    RC_ASSERT(ways.size() == 1u);
    const double needed_px = padding_px + kWritten_px;
    RC_ASSERT(std::abs(double(norm(ways[0])) - (deepest.depth_px + needed_px)) < kRounding_px);
    const Vec2 way = ways[0] * (by_own ? 1.f : -1.f);
    const Vec2 out = deepest.vertex + way * float(deepest.depth_px / norm(way));
    RC_ASSERT(test::boundary_distance({{{out}}}, by_own ? meeting.other() : meeting.piece) < kRounding_px);
  }));
}

/// The canvas' edge may reach into a long side without touching a vertex.
TEST(PlacedOutlines, TheCanvasEdgeIsLookedForAlongTheSides) {
  Grid<float> coverage(800, 800, 1.f);  // two cells a px
  for (int y = 340; y < 366; ++y) {
    for (int x = 412; x < 420; ++x) coverage(x, y) = 0;
  }
  const FreeField free(make_mask_canvas(coverage), padded_by(0));
  const PlacedOutlines outlines(free, padded_by(0));
  EXPECT_TRUE(outlines.conflicts(square(), pose(40, 0, {200, 203})).empty());
  EXPECT_EQ(outlines.conflicts(square(), pose(40, 0, {200, 200})).size(), 1u);
}

TEST(PlacedOutlines, TheCanvasEdgeIsANeighbour) {
  const Shape& bean = shapes()[1];
  const float left = bounding_box(bean.outline.curves[0]).low.x * 40;
  const auto conflicts = [&](float padding_px, float to_the_edge_px) {
    return Scene(padding_px).outlines.conflicts(bean, pose(40, 0, {to_the_edge_px - left, 200}));
  };
  EXPECT_TRUE(conflicts(kPadding_px, kPadding_px + 0.05f).empty());
  const std::vector<Vec2> ways = conflicts(kPadding_px, kPadding_px - 1);
  ASSERT_EQ(ways.size(), 1u);
  EXPECT_NEAR(ways[0].x, 1, 0.05);
  EXPECT_NEAR(ways[0].y, 0, 0.05);
  EXPECT_TRUE(conflicts(0, -kOverlap_px + 0.05f).empty());
  EXPECT_EQ(conflicts(0, -kOverlap_px - 0.2f).size(), 1u);
}

TEST(PlacedOutlines, ReplacedOnesAreAsIfPlacedAfresh) {
  class Library : public ShapeSource {
   public:
    const Shape& shape(ShapeId id) override {
      ++asked;
      return shapes().at(index_of(id));
    }
    const ShapeModel& model(ShapeId) override { throw std::logic_error("no model is needed"); }
    int asked = 0;
  } library;
  Scene scene(kPadding_px);
  const Placement kept{ShapeId{1}, pose(30, 0, {100, 100}), 1, 1};
  const Placement gone{ShapeId{1}, pose(30, 0, {200, 100}), 1, 1};
  const Placement come{ShapeId{1}, pose(30, 1, {100, 200}), 1, 1};
  scene.outlines.replace({kept, gone}, library);
  scene.outlines.replace({come, kept}, library);
  EXPECT_EQ(library.asked, 3) << "what stays is not made again";
  const auto conflict_at = [&](const Placement& p) {
    return !scene.outlines.conflicts(shapes()[index_of(p.shape)], p.canvas_from_shape).empty();
  };
  EXPECT_TRUE(conflict_at(kept));
  EXPECT_TRUE(conflict_at(come));
  EXPECT_FALSE(conflict_at(gone));
}

/// A placed piece has the same conflicts as a new piece in its pose, after any moves and removals.
TEST(PlacedOutlines, ConflictsOfAPlacedPieceAreThoseOfOneThatComes) {
  EXPECT_TRUE(rc::check([] {
    const PieceSettings pieces = *rc::gen::element(padded_by(kPadding_px), overlapping_by(kOverlap_px));
    Scene all(pieces), others(pieces);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t shape = any_shape();
      const Similarity where = any_pose(200, 40);
      all.add(shape, where);
      others.add(shape, where);
    }
    for (int k = 0; k < 2; ++k)
      all.outlines.add({ShapeId{}, pose(20, 0, {200, 200}), 1, 1}, shapes()[0].outline, INFINITY);
    const Shape& shape = shapes()[any_shape()];
    const Similarity where = any_pose(200, 40);
    all.outlines.move(3, where, shape.outline);
    all.outlines.take_out(4);
    // Decides by outlines alone: the field makes every vertex suspect.
    const auto always = [](std::size_t, Vec2) { return -1.f; };
    const std::size_t found = all.outlines.conflicts_of(3, always).size();
    RC_TAG(found);
    RC_ASSERT(found == others.outlines.conflicts(shape, where).size());
  }));
}

/// Processor time of the conflict queries for all places of a square grid of pieces, each just far enough from the others.
double time_for_all_s(int across) {
  constexpr float kWide_px = 40;
  constexpr float kSpacing_px = 60;
  Scene scene(kWide_px, kSpacing_px * float(across + 1));
  std::vector<Similarity> poses;
  for (int i = 0; i < across * across; ++i) {
    poses.push_back(pose(9, 0.1f * float(i), Vec2{float(1 + i % across), float(1 + i / across)} * kSpacing_px));
    scene.add(3, poses.back());
  }
  double least_s = INFINITY;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const std::clock_t begin = std::clock();
    for (const Similarity& p : poses) EXPECT_EQ(scene.outlines.conflicts(shapes()[3], p).size(), 1u) << "itself alone";
    least_s = std::min(least_s, double(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least_s;
}

/// The padding is wider than the pieces. Even then a piece is compared with its neighbours, not with all pieces.
TEST(PlacedOutlines, FourTimesThePiecesAreNotSixteenTimesTheWork) {
  const double hundred_s = time_for_all_s(10);
  EXPECT_LT(time_for_all_s(20), 9 * hundred_s);
}

TEST(PlacedOutlines, APieceDoesNotSwallowASmallZone) {
  Canvas canvas = make_rectangle_canvas(200, 200);
  take_out(distance_to({KeepOutRectangle{{100, 100}, {4, 4}}}, canvas), canvas);
  for (const float padding_px : {0.f, 2.f}) {
    const FreeField free(canvas, padded_by(padding_px));
    const PlacedOutlines outlines(free, padded_by(padding_px));
    EXPECT_FALSE(outlines.conflicts(square(), pose(80, 0, {100, 100})).empty());
    EXPECT_FALSE(outlines.conflicts(square(), pose(80, 0, {110, 95})).empty());
    EXPECT_TRUE(outlines.conflicts(square(), pose(60, 0, {50, 100})).empty());
  }
}

}  // namespace test_placed_outlines
}  // namespace tessera
