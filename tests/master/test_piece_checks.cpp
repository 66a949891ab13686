// Checks of candidates: what was computed ahead is what would be computed now, whatever has been placed since.
#include "master/choosing/piece_checks.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "core/field/line_art.h"
#include "core/shape/shape_field.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_piece_checks {

using namespace whole_collage;

/// Counts the shapes that are asked for.
class CountedShapes : public test::VectorShapes {
 public:
  CountedShapes() : VectorShapes(library()) {}
  const Shape& shape(ShapeId id) override {
    ++asked;
    return VectorShapes::shape(id);
  }
  int asked = 0;
};

/// A field with its pieces, and checks on it.
struct Scene {
  explicit Scene(const Canvas& canvas, const CollageSettings& s = settings())
      : pieces(s.pieces),
        context(make_matching_context(s, std::uint32_t(library().size()))),
        free(canvas, s.pieces),
        opened(free, s.pieces),
        outlines(free, s.pieces),
        settling(free, outlines, context),
        checks(shapes, free, opened, settling, pieces, context) {}

  void place(const Placement& piece) {
    const Shape& shape = library()[index_of(piece.shape)];
    outlines.add(piece, shape.outline, line_radius(shape.field, shape.perimeter));
    stamped.push_back(free.stamp(shape, piece.canvas_from_shape));
    checks.forget_near(shape, piece.canvas_from_shape, stamped.back());
  }

  void end_batch() {
    for (const Window& window : opened.update(free, stamped)) checks.forget(window);
    stamped.clear();
  }

  PieceSettings pieces;
  MatchingContext context;
  CountedShapes shapes;
  FreeField free;
  OpenedField opened;
  PlacedOutlines outlines;
  Settling settling;
  PieceChecks checks;
  std::vector<Window> stamped;  // since the end of a batch
};

Candidate candidate_at(const Similarity& pose, std::uint32_t shape = 3) {
  Candidate candidate;
  candidate.shape = ShapeId{shape};
  candidate.canvas_from_shape = pose;
  return candidate;
}

Similarity random_pose(float canvas_px) {
  const auto along = [&] { return 0.01f * float(*rc::gen::inRange(0, int(100 * canvas_px))); };
  const float scale_px = 0.1f * float(*rc::gen::inRange(200, 900));
  const float angle_rad = 0.001f * float(*rc::gen::inRange(0, 6283));
  return {scale_px * std::cos(angle_rad), scale_px * std::sin(angle_rad), along(), along()};
}

bool same(const SettledPiece& a, const SettledPiece& b) {
  if (!a.fits || !b.fits) return a.fits == b.fits;
  return a.canvas_from_shape == b.canvas_from_shape && a.terms == b.terms && a.areas.gap_px2 == b.areas.gap_px2 &&
         a.areas.overlap_px2 == b.areas.overlap_px2;
}

TEST(PieceChecks, WhatWasComputedAheadIsTrueOfTheFieldAsItIs) {
  for (const bool seamless : {false, true}) {
    const Canvas canvas = seamless ? make_seamless_canvas(400, 400, true, true) : make_rectangle_canvas(400, 400);
    EXPECT_TRUE(rc::check([&] {
      Scene scene(canvas);
      const auto any_shape = [] { return std::uint32_t(*rc::gen::inRange(0, int(library().size()))); };
      std::vector<Candidate> candidates;
      for (int i = 0; i < 12; ++i) candidates.push_back(candidate_at(random_pose(400), any_shape()));
      scene.place({ShapeId{any_shape()}, random_pose(400), 1, 1});
      for (int step = 0; step < 3; ++step) {
        scene.checks.compute_areas_ahead(candidates);
        scene.checks.settle_ahead(candidates);
        scene.place({ShapeId{any_shape()}, random_pose(400), 1, 1});
        if (*rc::gen::arbitrary<bool>()) scene.end_batch();
        PieceChecks now(scene.shapes, scene.free, scene.opened, scene.settling, scene.pieces, scene.context);
        for (const Candidate& candidate : candidates) {
          RC_ASSERT(same(scene.checks.settled(candidate), now.settled(candidate)));
          RC_ASSERT(scene.checks.areas(candidate).gap_px2 == now.areas(candidate).gap_px2);
          RC_ASSERT(scene.checks.areas(candidate).overlap_px2 == now.areas(candidate).overlap_px2);
        }
      }
    }));
  }
}

/// Half a largest piece is the least distance between the windows of pieces of a batch.
TEST(PieceChecks, APieceOfTheSameBatchLeavesThemKnown) {
  Scene scene(make_rectangle_canvas(800, 400));
  const Candidate candidate = candidate_at({60, 0, 200, 200});
  scene.checks.compute_areas_ahead({candidate});
  scene.checks.settle_ahead({candidate});
  const float largest_px = scene.pieces.max_scale_px;
  scene.place({ShapeId{3}, {largest_px, 0, 200 + 60 + kBatchClearance * largest_px + largest_px, 200}, 1, 1});
  scene.shapes.asked = 0;
  EXPECT_TRUE(scene.checks.knows_areas(candidate));
  EXPECT_TRUE(scene.checks.settled(candidate).fits);
  scene.checks.areas(candidate);
  EXPECT_EQ(scene.shapes.asked, 0);
}

/// Sizes may become smaller from piece to piece (fit = "all"). The piece that a candidate becomes may grow to the new ones.
TEST(PieceChecks, AnswersAreThoseOfThePresentSizes) {
  Scene scene(make_rectangle_canvas(400, 400));
  const Candidate candidate = candidate_at({60, 0, 200, 200});
  scene.checks.settle_ahead({candidate});
  const float settled_px = scene.checks.settled(candidate).canvas_from_shape.scale();
  const StanceTable all = scene.context.stances;
  limit(scene.context, all, {.most_scale_px = 61});
  EXPECT_LE(scene.checks.settled(candidate).canvas_from_shape.scale(), 61.01f);
  limit(scene.context, all, {});
  EXPECT_EQ(scene.checks.settled(candidate).canvas_from_shape.scale(), settled_px);
  EXPECT_GT(settled_px, 65) << "it grows in any case, so this test says something";
}

TEST(PieceChecks, ForgetAllForgetsAreas) {
  Scene scene(make_rectangle_canvas(400, 400));
  const Candidate candidate = candidate_at({60, 0, 200, 200});
  scene.checks.compute_areas_ahead({candidate});
  EXPECT_TRUE(scene.checks.knows_areas(candidate));
  scene.checks.forget_all();
  EXPECT_FALSE(scene.checks.knows_areas(candidate));
}

}  // namespace test_piece_checks
}  // namespace tessera::master
