// The data of a replacement window about the job, the canvas and the other pieces.
#include "master/replacing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/replacing/repetition_costs.h"
#include "replacing_batches.h"

namespace tessera::master {
namespace test_replacement_windows {

using namespace replacing_batches;

TEST(ReplacementWindows, AllShapesOfASmallLibraryMayComeIn) {
  Batches batches(large_canvas());
  test::AskedReplacer replacer;
  batches.batch(replacer);
  for (const ReplacementWindow& w : replacer.windows()) {
    ASSERT_EQ(w.incoming.size(), 12u);
    for (std::uint32_t i = 0; i < 12; ++i) {
      EXPECT_EQ(w.incoming[i].shape, ShapeId{i});
      EXPECT_EQ(w.incoming[i].drawing, ShapeId(i & ~1u));
      EXPECT_EQ(w.incoming[i].weight, 1);
      EXPECT_EQ(w.incoming[i].poses.min_scale_px, 40);
      EXPECT_EQ(w.incoming[i].poses.max_scale_px, 80);
    }
  }
}

TEST(ReplacementWindows, OfALargeLibraryAsManyMayComeInAsCanBeLookedAt) {
  for (const std::uint32_t shapes : {400u, 401u, 5000u}) {
    Batches batches(large_canvas(), settings_40_to_80(), shapes);
    test::AskedReplacer replacer;
    std::set<ShapeId> different;
    for (int batch = 1; batch <= 2; ++batch) {
      batches.batch(replacer, 0, {std::uint64_t(batch), 100'000});
      for (const ReplacementWindow& w : replacer.windows()) {
        EXPECT_EQ(w.incoming.size(), 400u);
        for (const IncomingShape& in : w.incoming) different.insert(in.shape);
      }
      EXPECT_LE(different.size(), std::size_t(400 * batch)) << "the same in all windows of a batch";
    }
    EXPECT_LT(index_of(*different.rbegin()), shapes);
    if (shapes == 5000) {
      EXPECT_GT(different.size(), 600u) << "others in each batch";
      EXPECT_GT(index_of(*different.rbegin()), 4500u) << "of all of it";
    }
  }
}

TEST(ReplacementWindows, ShapesComeInAsTheyMayStandAndAsOftenAsTheyAreWishedFor) {
  CollageSettings s = settings_40_to_80();
  s.wishes.classes.resize(3);
  s.wishes.classes[0].weight = 4;
  s.wishes.classes[0].poses.scale_px = {{40, 50}, {70, 80}};
  s.wishes.classes[1].weight = 1;
  s.wishes.classes[2].weight = 0;
  s.wishes.class_of_shape = {0, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  Batches batches(make_rectangle_canvas(300, 220), s);
  test::AskedReplacer replacer;
  batches.batch(replacer);
  const std::vector<IncomingShape>& incoming = replacer.windows().at(0).incoming;
  ASSERT_EQ(incoming.size(), 12u) << "the first in two stances, and not the third";
  EXPECT_EQ(incoming[0].shape, incoming[1].shape);
  EXPECT_EQ(incoming[0].poses.max_scale_px, 50);
  EXPECT_EQ(incoming[1].poses.min_scale_px, 70);
  EXPECT_EQ(incoming[1].weight, 1);
  EXPECT_EQ(incoming[2].shape, ShapeId{1});
  EXPECT_EQ(incoming[2].weight, 0.25f) << "of that of the most wished for";
  for (const IncomingShape& in : incoming) EXPECT_NE(in.shape, ShapeId{2});
}

TEST(ReplacementWindows, WhatADrawingCoversIsThatOfAllItsPieces) {
  CollageSettings s = settings_40_to_80();
  s.objective.repetition_exponent = 0.5f;
  Batches batches(large_canvas(), s);
  test::AskedReplacer replacer;
  batches.batch(replacer, 10);
  for (const ReplacementWindow& w : replacer.windows()) {
    ASSERT_EQ(w.drawn.size(), 6u) << "drawings";
    for (std::size_t i = 0; i < w.drawn.size(); ++i) {
      EXPECT_EQ(w.drawn[i].drawing, ShapeId(std::uint32_t(2 * i))) << "ascending";
      double area_px2 = 0;
      for (const Placement& p : batches.placements) {
        const bool shows_it = (index_of(p.shape) & ~1u) == index_of(w.drawn[i].drawing);
        if (shows_it) area_px2 += std::pow(double(p.canvas_from_shape.scale()), 2);
      }
      EXPECT_GT(area_px2, 0);
      EXPECT_NEAR(w.drawn[i].area_px2, area_px2, 1e-6 * area_px2);
    }
    EXPECT_DOUBLE_EQ(w.repetition.area, 0.1 * 0.5);
    EXPECT_DOUBLE_EQ(w.repetition.nearness, 0.5);
  }
}

TEST(ReplacementWindows, MirrorImagesAreOneDrawing) {
  test::AskedReplacer replacer;
  Batches(large_canvas()).batch(replacer);
  EXPECT_EQ(replacer.windows().at(0).repetition, repetition_costs(settings_40_to_80(), 6, 800. * 700));
}

/// A window leaves out drawings that neither move in it nor may come in.
TEST(ReplacementWindows, WhatOtherDrawingsCoverIsLeftOut) {
  CollageSettings s = settings_40_to_80();
  s.wishes.classes.resize(2);
  s.wishes.classes[1].weight = 0;
  s.wishes.class_of_shape = {0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  Batches batches(large_canvas(), s);
  test::AskedReplacer replacer;
  batches.batch(replacer, batches.placements.size() - 1);  // one piece may move
  ASSERT_EQ(replacer.windows().size(), 1u);
  const ReplacementWindow& w = replacer.windows()[0];
  ASSERT_EQ(w.moving.size(), 1u);
  std::set<ShapeId> expected = {ShapeId{0}, w.moving[0].drawing};
  ASSERT_EQ(w.drawn.size(), expected.size());
  for (const DrawingArea& drawn : w.drawn) EXPECT_TRUE(expected.count(drawn.drawing));
}

/// The distance up to which a copy of a piece of the largest size counts, with six drawings.
const float kNearness_px = 0.5f * std::sqrt(6.f) * 80;

float beyond_px(const Box& box, Vec2 p) {
  return std::max({box.low.x - p.x, p.x - box.high.x, box.low.y - p.y, p.y - box.high.y, 0.f});
}

/// The pieces and their images that may count as copies in a window.
std::vector<PlacedDrawing> near_to(const ReplacementWindow& w, const std::vector<Placement>& all,
                                   const Period& period) {
  std::vector<PlacedDrawing> near;
  for (const Placement& p : all) {
    for (const Vec2 offset : period.offsets()) {
      near.push_back(placed_drawing(ShapeId(index_of(p.shape) & ~1u), moved(p.canvas_from_shape, offset)));
      if (beyond_px(w.box, near.back().centre_px) > kNearness_px) near.pop_back();
    }
  }
  return near;
}

TEST(ReplacementWindows, CopiesThatMayBeFeltAreThoseThatMoveAndTheOthers) {
  Batches batches(make_rectangle_canvas(1500, 1300));
  test::AskedReplacer replacer;
  batches.batch(replacer, 3);
  ASSERT_GT(replacer.windows().size(), 3u);
  for (const ReplacementWindow& w : replacer.windows()) {
    std::vector<PlacedDrawing> felt = w.elsewhere;
    for (const WindowPiece& p : w.moving) felt.push_back(placed_drawing(p.drawing, p.canvas_from_shape));
    const std::vector<PlacedDrawing> near = near_to(w, batches.placements, {});
    EXPECT_LT(near.size(), batches.placements.size());
    EXPECT_TRUE(std::is_permutation(felt.begin(), felt.end(), near.begin(), near.end()));
  }
}

TEST(ReplacementWindows, OnASeamlessCanvasCopiesAreFeltAcrossItsEdge) {
  const Canvas canvas = make_seamless_canvas(1500, 1300, true, false);
  Batches batches(canvas);
  test::AskedReplacer replacer;
  batches.batch(replacer, 3);
  std::size_t across = 0;
  for (const ReplacementWindow& w : replacer.windows()) {
    const std::vector<PlacedDrawing> near = near_to(w, batches.placements, canvas.period);
    for (const PlacedDrawing& piece : w.elsewhere) {
      EXPECT_EQ(std::count(near.begin(), near.end(), piece), 1);
      across += piece.centre_px.x < 0 || piece.centre_px.x > 1500;
    }
    EXPECT_GE(w.elsewhere.size() + 2 * w.moving.size(), near.size()) << "all but images of what moves in it";
  }
  EXPECT_GT(across, 10u);
}

TEST(ReplacementWindows, DistancesAndSizesAreThoseOfTheJob) {
  CollageSettings s = settings_40_to_80();
  s.pieces.padding_px = 3;
  Batches batches(make_rectangle_canvas(300, 220), s);
  test::AskedReplacer replacer;
  batches.batch(replacer);
  const ReplacementWindow& w = replacer.windows().at(0);
  EXPECT_NEAR(w.distances.soft_px, 3.3, 1e-5);
  EXPECT_NEAR(w.distances.hard_px, 3.1, 1e-5);
  EXPECT_EQ(w.least_scale_px, 40);
  EXPECT_EQ(w.most_scale_px, 80);
}

}  // namespace test_replacement_windows
}  // namespace tessera::master
