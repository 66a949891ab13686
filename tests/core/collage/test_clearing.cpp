// The clearing that makes relaxed pieces stand without conflicts.
#include "core/collage/clearing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/relax/schedules.h"
#include "core/relaxed_pieces.h"

namespace tessera {
namespace test_clearing {

using namespace relaxed_pieces;

/// The number of conflicts by the rule that the master applies before it places a piece, with all others in the free field.
std::size_t conflicts_among(const std::vector<RelaxedPiece>& pieces, const std::vector<std::size_t>& dropped,
                            const Canvas& canvas, const PieceSettings& settings) {
  const auto is_dropped = [&](std::size_t i) { return std::count(dropped.begin(), dropped.end(), i) > 0; };
  const auto shape_of = [&](std::size_t i) -> const Shape& {
    return shapes()[std::size_t(pieces[i].shape - contact_shapes().data())];
  };
  std::size_t conflicts = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (is_dropped(i)) continue;
    FreeField free(canvas, settings);
    PlacedOutlines others(free, settings);
    for (std::size_t j = 0; j < pieces.size(); ++j) {
      if (j == i || is_dropped(j)) continue;
      others.add({ShapeId{}, pieces[j].canvas_from_shape}, shape_of(j).outline, INFINITY);
      free.stamp(shape_of(j), pieces[j].canvas_from_shape);
    }
    conflicts += others.conflicts(shape_of(i), pieces[i].canvas_from_shape).size();
  }
  return conflicts;
}

TEST(Clearing, LeavesNoConflictWhateverTheRule) {
  const Canvas canvas = make_rectangle_canvas(kCanvas_px, kCanvas_px);
  const Canvas tube = make_seamless_canvas(kCanvas_px, kCanvas_px, true, false);
  EXPECT_TRUE(rc::check([&] {
    PieceSettings settings;
    settings.padding_px = *rc::gen::element(0.f, 2.f);
    settings.overlap_px = *rc::gen::element(0.f, 0.0005f, 1.4f);
    settings.max_scale_px = 60;
    const Canvas& where = **rc::gen::element(&canvas, &tube);
    std::vector<RelaxedPiece> pieces = any_pieces(kCanvas_px);
    pieces.resize(8);
    const FreeField free(where, settings);
    Relaxation(free, contact_distances(settings)).relax(pieces, all_of(pieces), kShort, do_not_look);
    const std::vector<std::size_t> dropped = make_clear(pieces, all_of(pieces), free, settings, do_not_look);
    RC_TAG(dropped.size());
    RC_ASSERT(dropped.size() < pieces.size() / 2);
    RC_ASSERT(conflicts_among(pieces, dropped, where, settings) == 0u);
    for (const RelaxedPiece& p : pieces) RC_ASSERT(p.poses.contains(p.canvas_from_shape));
  }));
}

TEST(Clearing, APieceWithoutRoomBetweenFixedOnesIsReported) {
  const PieceSettings settings;
  std::vector<RelaxedPiece> pieces;
  for (const float x : {80.f, 100.f, 120.f}) pieces.push_back(piece(kDisc, pose(40, 0, {x, 100}), {40, 40, {}}));
  for (const std::size_t i : {0u, 2u}) pieces[i].fixed = true;
  const Canvas slit = [] {
    Grid<float> coverage(400, 400, 0.f);
    for (int y = 150; y < 250; ++y) {
      for (int x = 80; x < 320; ++x) coverage(x, y) = 1;
    }
    return make_mask_canvas(coverage);
  }();
  const FreeField free(slit, settings);
  const std::vector<std::size_t> dropped = make_clear(pieces, {0, 1, 2}, free, settings, do_not_look);
  EXPECT_EQ(dropped, std::vector<std::size_t>{1});
  EXPECT_EQ(pieces[0].canvas_from_shape, pose(40, 0, {80, 100}));
}

/// A bar with vertices all along its sides.
Outline bar(float length, float width) {
  std::vector<Vec2> curve;
  for (float x = 0; x < length; ++x) curve.push_back({x, 0});
  for (float x = length; x > 0; --x) curve.push_back({x, width});
  return {{curve}};
}

/// A push cannot part these two pieces, and both would lose a third of their size until they are apart.
TEST(Clearing, OfLimbsThatCrossTheSmallerPieceGoesBeforeTheOtherHasShrunk) {
  const ContactShape shape = make_contact_shape(test::make_test_shape("bar", bar(100, 8)));
  std::vector<RelaxedPiece> pieces;
  for (const float scale_px : {60.f, 50.f}) {
    const float angle_rad = scale_px > 55 ? 0.f : 1.57f;
    pieces.push_back({&shape, pose(scale_px, angle_rad, {150, 150}), {10, 500, {}}});
  }
  EXPECT_EQ(make_clear(pieces, {0, 1}, rectangle(300), {}, do_not_look), std::vector<std::size_t>{1});
  EXPECT_GT(pieces[0].canvas_from_shape.scale(), 0.98f * 60);
}

/// A piece that was given up does not affect the others, and stays where it was. A third piece, slightly too near, is pushed clear.
TEST(Clearing, WhoWasGivenUpIsNotFelt) {
  const ContactShape shape = make_contact_shape(test::make_test_shape("bar", bar(100, 8)));
  std::vector<RelaxedPiece> pieces{{&shape, pose(60, 0, {150, 150}), {10, 500, {}}},
                                   {&shape, pose(50, 1.57f, {150, 150}), {10, 500, {}}}};
  for (const float y_px : {166.f, 180.f}) pieces.push_back({&shape, pose(60, 0, {150, y_px}), {59, 500, {}}});
  const std::vector<std::size_t> lost = make_clear(pieces, {0, 1, 2, 3}, rectangle(300), {}, do_not_look);
  EXPECT_EQ(lost, std::vector<std::size_t>{1}) << "it crosses all three";
  for (const std::size_t i : {0u, 2u, 3u}) EXPECT_GT(pieces[i].canvas_from_shape.scale(), 58.9f);
}

/// With padding, pieces that are too near are far from crossing. Two that fill a slit shrink until they have their distance.
TEST(Clearing, PiecesThatAreOnlyTooNearAreNotGivenUp) {
  PieceSettings settings;
  settings.padding_px = 6;
  const float width_px = 2 * 2 * kDiscRadius * 50 + 3 * settings.padding_px;
  const Canvas slit = make_rectangle_canvas(int(width_px) - 10, 75);
  std::vector<RelaxedPiece> pieces;
  for (const float x : {0.27f, 0.73f}) {
    pieces.push_back(piece(kDisc, pose(50, 0, {x * float(slit.width_px), 37}), {30, 500, {}}));
  }
  EXPECT_EQ(make_clear(pieces, {0, 1}, {slit, settings}, settings, do_not_look), std::vector<std::size_t>{});
}

/// A single piece that is too large for the canvas only has to shrink.
TEST(Clearing, NobodyIsGivenUpForTheCanvasEdge) {
  const PieceSettings settings;
  const float largest_px = (50 + settings.overlap_px) / kDiscRadius;
  std::vector<RelaxedPiece> pieces{piece(kDisc, pose(1.06f * largest_px, 0, {50, 50}), {10, 500, {}})};
  EXPECT_EQ(make_clear(pieces, {0}, rectangle(100), settings, do_not_look), std::vector<std::size_t>{});
}

/// The steps of shrinking are coarse, so clearing lets pieces grow again as far as the outlines allow.
TEST(Clearing, APieceIsAsLargeAsTheOutlinesAllow) {
  const PieceSettings settings;
  const FreeField square = rectangle(100);
  const float largest_px = (50 + settings.overlap_px) / kDiscRadius;
  std::vector<RelaxedPiece> pieces{piece(kDisc, pose(1.02f * largest_px, 0, {50, 50}), {10, 500, {}})};
  EXPECT_EQ(make_clear(pieces, {0}, square, settings, do_not_look), std::vector<std::size_t>{});
  EXPECT_GT(pieces[0].canvas_from_shape.scale(), 0.998f * largest_px);
}

/// Clearing does not enlarge pieces, though a single piece has room to grow.
TEST(Clearing, APieceBecomesHardlyLargerThanItWas) {
  std::vector<RelaxedPiece> pieces{piece(kDisc, pose(30, 0, {50, 50}), {10, 500, {}})};
  make_clear(pieces, {0}, rectangle(100), {}, do_not_look);
  EXPECT_LT(pieces[0].canvas_from_shape.scale(), 30.101f);
}

}  // namespace test_clearing
}  // namespace tessera
