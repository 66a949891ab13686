// Batches: the pieces that are placed before anything is matched or measured again.
#include "master/rules/batch.h"

#include <gtest/gtest.h>

#include "master/filling.h"
#include "rounds_by_hand.h"
#include "support/colours.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_batch {

using namespace whole_collage;

CollageSettings small_pieces() {
  CollageSettings s = settings();
  s.pieces.min_scale_px = 15;
  s.pieces.max_scale_px = 40;
  return s;
}

const Canvas& wide_canvas() {
  static const Canvas wide = make_rectangle_canvas(500, 400);
  return wide;
}

TEST(Batch, TheFirstPieceDecidesWhatOthersMustBeWorth) {
  const PeriodicGrid grid(Window{0, 0, 1000, 1000});
  Batch batch(grid, small_pieces());
  EXPECT_FALSE(batch.is_open());
  EXPECT_EQ(batch.least_worth(), 0);
  batch.add({0, 0, 10, 10}, {}, 2);
  batch.add({500, 500, 510, 510}, {}, 2.5f);
  EXPECT_TRUE(batch.is_open());
  EXPECT_EQ(batch.pieces(), 2u);
  EXPECT_FLOAT_EQ(batch.least_worth(), 2 * kBatchWorth);
  batch.end();
  EXPECT_FALSE(batch.is_open());
  EXPECT_EQ(batch.least_worth(), 0);
}

/// Many colours of a picture are hard to match. They are no reason to wait.
TEST(Batch, WhereAPictureIsShownLittleIsEnough) {
  const PeriodicGrid grid(Window{0, 0, 1000, 1000});
  CollageSettings s = small_pieces();
  s.colour.target = test::picture(8, 8, [](Vec2) { return test::opaque({50, 0, 0}); });
  Batch batch(grid, s);
  batch.add({0, 0, 10, 10}, {}, 2);
  EXPECT_FLOAT_EQ(batch.least_worth(), 2 * kBatchWorthInPicture);
}

/// Cells of eight nodes are taken as a whole.
TEST(Batch, KeepsHalfALargestPieceBetweenWindows) {
  const PeriodicGrid grid(Window{0, 0, 1000, 1000});
  Batch batch(grid, small_pieces());
  batch.add({100, 100, 150, 140}, {}, 1);
  batch.add({700, 700, 710, 710}, {}, 1);
  EXPECT_TRUE(batch.touches({149, 139, 160, 160}));
  EXPECT_FALSE(batch.touches({150, 139, 160, 160}));
  EXPECT_FALSE(batch.has_room_for({169, 100, 200, 140}));
  EXPECT_TRUE(batch.has_room_for({177, 100, 200, 140}));
  EXPECT_FALSE(batch.has_room_for({729, 690, 760, 720}));
  EXPECT_TRUE(batch.has_room_for({737, 690, 760, 720}));
}

TEST(Batch, WhatOverlapsABetterCandidateThatWaitsHasToWaitToo) {
  const PeriodicGrid grid(Window{0, 0, 1000, 1000});
  Batch batch(grid, small_pieces());
  batch.add({0, 0, 10, 10}, {}, 1);
  const Window beside{300, 300, 340, 340};
  EXPECT_TRUE(batch.has_room_for(beside));
  batch.hold_back({330, 330, 400, 400});
  EXPECT_FALSE(batch.has_room_for(beside));
  EXPECT_FALSE(batch.touches(beside));
  batch.end();
  EXPECT_TRUE(batch.has_room_for(beside));
}

TEST(Batch, SeesWhatIsNearAcrossASeam) {
  const Canvas canvas = make_seamless_canvas(400, 300, true, true);
  const FreeField free(canvas, small_pieces().pieces);
  const Window& period = free.grid().one_period();
  Batch batch(free.grid(), small_pieces());
  batch.add({period.x0, period.y0 + 100, period.x0 + 20, period.y0 + 120}, {}, 1);
  EXPECT_FALSE(batch.has_room_for({period.x1 - 30, period.y0 + 100, period.x1 - 10, period.y0 + 120}));
  EXPECT_TRUE(batch.has_room_for({period.x1 - 60, period.y0 + 100, period.x1 - 40, period.y0 + 120}));
}

/// Every piece of a batch stands far from the others. Its terms are those of the present field, although nothing was measured
/// in between.
TEST(Batch, ItsPiecesAreFarApartAndMeasuredAsTheyStand) {
  const CollageSettings s = small_pieces();
  test::RoundsByHand rounds(wide_canvas(), s, library());
  test::VectorShapes shapes(library());
  Collage& collage = rounds.collage();
  int joined = 0;
  Candidate best;
  for (int round = 0; round < 6; ++round) {
    ASSERT_TRUE(rounds.choose(best));
    std::vector<Window> stand;
    do {
      for (const Window& w : stand) EXPECT_FALSE(w.grown(int(s.pieces.max_scale_px / 4)).overlaps(best.window));
      stand.push_back(best.window);
      EXPECT_EQ(best.terms, docking_terms(best.canvas_from_shape, shapes.model(best.shape), collage.free().view(),
                                          rounds.context()));
      collage.place(best);
      EXPECT_TRUE(collage.batch_is_open());
    } while (collage.choose(best));
    joined += int(stand.size()) - 1;
    rounds.end_batch();
    EXPECT_FALSE(collage.batch_is_open());
  }
  EXPECT_GE(joined, 5);
}

/// A collage that goes on from the saved state has never set a candidate aside.
TEST(Batch, WhenItEndsAllCandidatesCountAgain) {
  const CollageSettings s = small_pieces();
  test::RoundsByHand rounds(wide_canvas(), s, library());
  Candidate best;
  for (int round = 0; round < 8; ++round) {
    ASSERT_TRUE(rounds.choose(best));
    do rounds.collage().place(best);
    while (rounds.collage().choose(best));
    rounds.end_batch();
    test::RoundsByHand fresh(wide_canvas(), s, library());
    fresh.collage().restore(rounds.state());
    Candidate expected;
    const bool any = fresh.collage().choose(expected);
    ASSERT_EQ(rounds.collage().choose(best), any);
    if (any) {
      EXPECT_EQ(best.canvas_from_shape, expected.canvas_from_shape);
    }
  }
}

/// A batch lasts until nothing may join, with one question for all that its pieces touch.
TEST(Batch, ALargeCanvasNeedsFewRounds) {
  const CollageResult result = run(wide_canvas(), small_pieces());
  EXPECT_GT(result.placements.size(), 60u);
  EXPECT_LT(double(result.statistics.rounds), 0.7 * double(result.placements.size()));
  EXPECT_GT(quality(wide_canvas(), result).coverage, 0.7);
}

TEST(Batch, HasOnePieceWhereThereIsNoRoomForMore) {
  const Canvas small = make_rectangle_canvas(90, 70);
  CollageSettings s = settings();
  s.pieces.min_scale_px = 20;
  const CollageResult result = run(small, s);
  EXPECT_EQ(result.statistics.rounds, result.placements.size());
}

}  // namespace test_batch
}  // namespace tessera::master
